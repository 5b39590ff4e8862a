// What Tab offers at a place of a line. Reads names and folders, changes nothing.
#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include "interpreter/builtins.h"
#include "interpreter/repl.h"
#include "interpreter/repl_loop.h"

namespace udcp {
namespace {

namespace fs = std::filesystem;

constexpr std::array keywords{"alpha", "alpha0",    "and",    "animate", "assert", "check", "delta", "else", "f",
                              "false", "for",       "frames", "if",      "in",     "not",   "omega", "on",   "or",
                              "pi",    "plot",      "print",  "prove",   "rings",  "save",  "set",   "step", "sweep",
                              "then",  "triangles", "true",   "use",     "verify", "where"};

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || (c & 0x80) != 0;
}

bool starts_with(const std::string& text, const std::string& prefix) { return text.compare(0, prefix.size(), prefix) == 0; }

/// Where the string literal that holds the cursor begins (after its quote); npos outside of one.
std::size_t literal_begin(const std::string& line, std::size_t cursor) {
  std::size_t begin = std::string::npos;
  for (std::size_t i = 0; i < cursor; ++i) {
    if (begin == std::string::npos && line[i] == '#') return begin;
    if (begin != std::string::npos && line[i] == '\\')
      ++i;
    else if (line[i] == '"')
      begin = begin == std::string::npos ? i + 1 : std::string::npos;
  }
  return begin;
}

/// Where the file name of ":load name" begins; npos for other lines.
std::size_t command_file_begin(const std::string& line, std::size_t cursor) {
  for (const char* command : {":load ", ":save "}) {
    if (starts_with(line, command) && cursor >= 6) return std::min(line.find_first_not_of(' ', 6), cursor);
  }
  return std::string::npos;
}

std::size_t file_begin(const std::string& line, std::size_t cursor) {
  const std::size_t quoted = literal_begin(line, cursor);
  return quoted != std::string::npos ? quoted : command_file_begin(line, cursor);
}

/// Entries of a folder that continue `typed`; folders end in a slash, hidden files need their dot typed.
std::set<std::string> files(const std::string& typed) {
  constexpr std::size_t most = 1000;
  const std::size_t slash = typed.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : typed.substr(0, slash + 1);
  const std::string start = typed.substr(folder.size());
  std::set<std::string> found;
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : fs::path(folder), error), end;
       !error && entry != end && found.size() < most; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!starts_with(name, start) || (start.empty() && name[0] == '.')) continue;
    if (name.find_first_of("\"\\{}\n") != std::string::npos) continue;  // cannot stand in a literal as it is
    std::error_code unknown;
    found.insert(folder + name + (entry->is_directory(unknown) ? "/" : ""));
  }
  return found;
}

/// The function whose argument list the cursor is in; empty if none.
std::string enclosing_call(const std::string& line, std::size_t cursor) {
  std::vector<std::size_t> open;
  bool quoted = false;
  for (std::size_t i = 0; i < cursor; ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (quoted) continue;
    if (line[i] == '(' || line[i] == '[' || line[i] == '{') open.push_back(i);
    if ((line[i] == ')' || line[i] == ']' || line[i] == '}') && !open.empty()) open.pop_back();
  }
  if (open.empty() || line[open.back()] != '(') return {};
  std::size_t begin = open.back();
  while (begin > 0 && is_name_character(line[begin - 1])) --begin;
  return line.substr(begin, open.back() - begin);
}

void offer_arguments(std::set<std::string>& offered, const Session& session, const std::string& function) {
  if (function.empty()) return;
  if (const Builtin* builtin = find_builtin(function)) {
    for (const std::string_view name : builtin->named) offered.insert(std::string(name) + " = ");
  }
  const Value* value = session.find(function);
  const auto* user = value != nullptr ? value->as<FunctionValue>() : nullptr;
  if (user == nullptr) return;
  for (const std::string& name : user->parameters) offered.insert(name + " = ");
}

std::set<std::string> names(const Session& session, const std::string& line, std::size_t cursor) {
  std::set<std::string> offered(keywords.begin(), keywords.end());
  for (const std::string& name : session.names()) offered.insert(name);
  for (const Builtin& builtin : builtins()) offered.insert(std::string(builtin.name));
  offer_arguments(offered, session, enclosing_call(line, cursor));
  return offered;
}

std::set<std::string> candidates(const Session& session, const std::string& line, std::size_t begin, std::size_t cursor) {
  if (file_begin(line, cursor) != std::string::npos) return files(line.substr(begin, cursor - begin));
  std::set<std::string> offered;
  if (begin == 0 && starts_with(line, ":")) {
    for (const ReplCommand& command : repl_commands()) offered.insert(command.name);
  } else if (starts_with(line, ":help ")) {
    offered = {"functions", "atoms", "statements", "codes"};
    for (const Builtin& builtin : builtins()) offered.insert(std::string(builtin.name));
  } else if (starts_with(line, ":set ")) {
    offered = {"precision", "max_faces", "seed", "threads"};
  } else {
    offered = names(session, line, cursor);
  }
  return offered;
}

}  // namespace

std::size_t completion_begin(const std::string& line, std::size_t cursor) {
  cursor = std::min(cursor, line.size());
  const std::size_t file = file_begin(line, cursor);
  if (file != std::string::npos) return file;
  std::size_t begin = cursor;
  while (begin > 0 && is_name_character(line[begin - 1])) --begin;
  return begin == 1 && line[0] == ':' ? 0 : begin;
}

std::vector<std::string> completions(const Session& session, const std::string& line, std::size_t cursor) {
  cursor = std::min(cursor, line.size());
  const std::size_t begin = completion_begin(line, cursor);
  const std::string typed = line.substr(begin, cursor - begin);
  std::vector<std::string> fitting;
  for (const std::string& each : candidates(session, line, begin, cursor)) {
    if (starts_with(each, typed)) fitting.push_back(each);
  }
  return fitting;
}

}  // namespace udcp
