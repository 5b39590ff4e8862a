// Programs with their expected output: tests/programs/*.udcp. A line "# ----" starts the next program of a file. Expectations:
//   # expect: text           the next printed line; "..." at its end stands for the rest of the line
//   # expect warning: text   a warning that contains the text
//   # expect error: CODE     how the program ends
//   # expect refuted         an assertion is false
// Every program runs in an empty folder of its own that holds copies of the files in tests/programs.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "interpreter/report.h"
#include "interpreter/session.h"

namespace {

using namespace udcp;
namespace fs = std::filesystem;

struct Program {
  std::string name, text;
  std::vector<std::string> lines, warnings;
  std::string error;
  bool refuted = false;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

bool take(const std::string& line, const std::string& prefix, std::string& rest) {
  if (!line.starts_with(prefix)) return false;
  rest = line.substr(prefix.size());
  return true;
}

std::vector<Program> programs_of(const fs::path& file) {
  std::ifstream in(file);
  REQUIRE(in);
  const auto fresh = [&] { return Program{file.filename().string(), "", {}, {}, "", false}; };
  std::vector<Program> programs{fresh()};
  for (std::string line, rest; std::getline(in, line);) {
    Program& p = programs.back();
    if (line == "# ----") {
      programs.push_back(fresh());
      continue;
    }
    if (take(line, "# expect: ", rest)) p.lines.push_back(rest);
    if (take(line, "# expect warning: ", rest)) p.warnings.push_back(rest);
    if (take(line, "# expect error: ", rest)) p.error = rest;
    if (line == "# expect refuted") p.refuted = true;
    p.text += line + "\n";
  }
  return programs;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

bool matches(const std::string& expected, const std::string& line) {
  if (!expected.ends_with("...")) return expected == line;
  return line.starts_with(expected.substr(0, expected.size() - 3));
}

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("udcp_programs_" + std::to_string(reinterpret_cast<std::uintptr_t>(this)))) {
    fs::remove_all(path_);
    fs::copy(fs::path(UDCP_TEST_DATA).parent_path() / "programs", path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void run_program(const Program& program) {
  CAPTURE(program.name);
  CAPTURE(program.text);
  const Folder folder;
  std::vector<std::string> printed, warnings;
  Session session({}, {[&](const Value& value) {
                         for (const std::string& line : lines_of(to_text(value))) printed.push_back(line);
                       },
                       [&](const std::string& warning) { warnings.push_back(warning); },
                       {}});
  session.load_prelude();
  std::string error, message;
  try {
    session.run(program.text, program.name, folder.path());
  } catch (const ProgramError& e) {
    error = e.code;
    message = e.what();
  }
  CAPTURE(message);
  CHECK(error == program.error);
  CHECK((session.outcome() == Outcome::refuted) == program.refuted);
  CAPTURE(joined(printed));
  if (!program.refuted || !program.lines.empty()) {
    CHECK(printed.size() == program.lines.size());
    for (std::size_t i = 0; i < std::min(printed.size(), program.lines.size()); ++i) {
      CAPTURE(program.lines[i]);
      CAPTURE(printed[i]);
      CHECK(matches(program.lines[i], printed[i]));
    }
  }
  CAPTURE(joined(warnings));
  CHECK(warnings.size() == program.warnings.size());
  for (std::size_t i = 0; i < std::min(warnings.size(), program.warnings.size()); ++i)
    CHECK(warnings[i].find(program.warnings[i]) != std::string::npos);
}

}  // namespace

TEST_SUITE("interpreter") {
  TEST_CASE("the programs in tests/programs do what they say") {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(UDCP_TEST_DATA).parent_path() / "programs")) {
      if (entry.path().extension() != ".udcp" || entry.path().filename().string().starts_with("used_")) continue;
      for (const Program& program : programs_of(entry.path())) {
        run_program(program);
        ++count;
      }
    }
    CHECK(count >= 60);
  }
}
