// Errors and warnings as text with a caret, or as JSON lines; which exit code an outcome or a kind of error has.
#include <exception>
#include <new>

#include "interpreter/report.h"

namespace udcp {
namespace {

/// The printed code; that of E_UNKNOWN where the table has no entry, so that a missing row never hides the error itself.
std::string printed_code(const std::string& symbol) {
  const CodeEntry* entry = find_code(symbol);
  return (entry != nullptr ? entry : find_code("E_UNKNOWN"))->code;
}

struct Style {
  const char *error, *bold, *help, *reset;
};
Style style(bool colour) { return colour ? Style{"\033[1;31m", "\033[1m", "\033[1;36m", "\033[0m"} : Style{"", "", "", ""}; }

bool has_place(const ProgramError& error) { return !error.source.empty() && !error.file.empty(); }

/// The line with the carets (the last one) in the colour of errors.
std::string coloured_excerpt(const std::string& text, const Style& s) {
  const std::size_t line = text.rfind('\n');
  return line == std::string::npos ? text : text.substr(0, line + 1) + s.error + text.substr(line + 1) + s.reset;
}

std::string without_final_newline(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

}  // namespace

std::string to_text(const ProgramError& error, bool colour) {
  const Style s = style(colour);
  const std::string code = printed_code(error.code);
  std::string text = std::string(s.error) + "error[" + code + "]" + s.reset + s.bold + ": " + error.what() + s.reset;
  if (find_code(error.code) == nullptr && !error.code.empty()) text += " (" + error.code + ")";
  if (has_place(error)) {
    const grammar::Place place = grammar::place_of(error.source, error.span.begin);
    text += "\n  --> " + error.file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + "\n";
    text += coloured_excerpt(without_final_newline(grammar::excerpt(error.source, error.span, error.label)), s);
  } else if (!error.file.empty()) {
    text += "\n  --> " + error.file;
  }
  if (!error.help.empty()) text += std::string("\n") + s.help + "help:" + s.reset + " " + error.help;
  return text;
}

Json to_json(const ProgramError& error) {
  Json json{{"kind", "error"}, {"code", printed_code(error.code)}, {"symbol", error.code}};
  json["file"] = error.file.empty() ? Json(nullptr) : Json(error.file);
  json["line"] = nullptr;
  json["column"] = nullptr;
  if (has_place(error)) {
    const grammar::Place place = grammar::place_of(error.source, error.span.begin);
    json["line"] = place.line;
    json["column"] = place.column;
  }
  json["message"] = error.what();
  json["help"] = error.help.empty() ? Json(nullptr) : Json(error.help);
  return json;
}

std::string warning_text(const std::string& message, bool colour) {
  return (colour ? "\033[1;33mwarning\033[0m: " : "warning: ") + message;
}

Json warning_json(const std::string& message) { return Json{{"kind", "warning"}, {"message", message}}; }

ProgramError make_error(ErrorKind kind, const std::string& code, const std::string& message, const std::string& help) {
  ProgramError error(message);
  error.kind = kind;
  error.code = code;
  error.help = help;
  return error;
}

ProgramError current_error() {
  try {
    throw;
  } catch (const ProgramError& error) {
    return error;
  } catch (const Error& error) {
    return make_error(error.kind, error.code, error.what(), error.help);
  } catch (const grammar::SyntaxError& error) {
    ProgramError converted = make_error(ErrorKind::input, error.code, error.what(), error.help);
    converted.syntax = true;
    converted.incomplete = error.incomplete;
    converted.label = error.label;
    converted.span = error.span;
    return converted;
  } catch (const std::bad_alloc&) {
    return make_error(ErrorKind::limit, "E_MEMORY", "the memory of this machine is used up",
                      "take fewer rounds, or a smaller --max-faces so that the limit is met before the work starts");
  } catch (const std::exception& error) {
    return make_error(ErrorKind::internal, "E_INTERNAL", std::string("internal error: ") + error.what(),
                      "this is a mistake in udcp; please report it together with the program");
  } catch (...) {
    return make_error(ErrorKind::internal, "E_INTERNAL", "internal error of an unknown kind",
                      "this is a mistake in udcp; please report it together with the program");
  }
}

int exit_code(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::input:
    case ErrorKind::word:
    case ErrorKind::not_exact:
      return 2;
    case ErrorKind::limit:
      return 4;
    case ErrorKind::file:
      return 5;
    case ErrorKind::interrupted:
      return 130;
    case ErrorKind::internal:
      break;
  }
  return 70;  // EX_SOFTWARE of sysexits: our own mistake, and none of the codes that scripts act upon
}

int exit_code(Outcome outcome) { return outcome == Outcome::done ? 0 : outcome == Outcome::refuted ? 1 : 3; }

}  // namespace udcp
