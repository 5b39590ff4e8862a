// The table of error codes against the sources that use it, and against a list that pins every code and title.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "interpreter/report.h"

using namespace udcp;

namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// Every quoted E_... in the sources, comments left out.
std::set<std::string> symbols_in_sources() {
  const fs::path root = fs::path(UDCP_TEST_DATA).parent_path().parent_path();
  const std::regex comment("//[^\n]*"), symbol("\"(E_[A-Z0-9_]+)\"");
  std::set<std::string> found;
  for (const char* folder : {"operators", "grammar", "files", "proofs", "interpreter"}) {
    if (!fs::is_directory(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path& file = entry.path();
      if ((file.extension() != ".cpp" && file.extension() != ".h") || file.filename() == "codes.cpp") continue;
      const std::string text = std::regex_replace(contents(file), comment, "");
      for (std::sregex_iterator match(text.begin(), text.end(), symbol), end; match != end; ++match) found.insert((*match)[1]);
    }
  }
  return found;
}

}  // namespace

TEST_SUITE("interpreter") {
  TEST_CASE("every symbol in the sources has a code") {
    const std::set<std::string> used = symbols_in_sources();
    CHECK(used.size() > 40);  // the search itself works
    for (const std::string& symbol : used) {
      CAPTURE(symbol);
      CHECK(find_code(symbol) != nullptr);
    }
  }

  TEST_CASE("every code is used somewhere") {
    const std::set<std::string> used = symbols_in_sources();
    for (const CodeEntry& entry : codes()) {
      CAPTURE(entry.symbol);
      CHECK(used.contains(entry.symbol));
    }
  }

  TEST_CASE("codes and titles are those of the published list") {
    std::string listed;
    for (const CodeEntry& entry : codes()) {
      listed.append(entry.code).append(" ").append(entry.symbol).append(" ").append(entry.title).append("\n");
    }
    CHECK(listed == contents(fs::path(UDCP_TEST_DATA) / "codes.txt"));
  }

  TEST_CASE("no code and no symbol stands twice and every entry has a story") {
    std::set<std::string> seen;
    for (const CodeEntry& entry : codes()) {
      CAPTURE(entry.symbol);
      CHECK(seen.insert(entry.code).second);
      CHECK(seen.insert(entry.symbol).second);
      CHECK(std::regex_match(entry.code, std::regex("[WSGFLEIX][0-9][0-9]")));
      CHECK(std::string(entry.story).size() > 15);
      CHECK(std::string(entry.story).back() == '.');
    }
  }

  TEST_CASE("a code is found by its symbol and by its number") {
    REQUIRE(find_code("W03") != nullptr);
    CHECK(std::string(find_code("W03")->symbol) == "E_P_DUAL");
    CHECK(find_code("E_P_DUAL") == find_code("W03"));
    CHECK(find_code("W") == nullptr);
    CHECK(find_code("") == nullptr);
  }
}
