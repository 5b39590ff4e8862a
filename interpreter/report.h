// Values, claims and errors as text or JSON lines; the one table of codes.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "interpreter/session.h"
#include "interpreter/value.h"

namespace udcp {

/// For people: exact first, then about 12 digits: "-17/48 + 5*sqrt(5)/48  (= -0.121243…)"; enclosures as [lo, hi].
std::string to_text(const Value&);
/// One JSON object {"kind": …, "value": …} with rationals as strings and enclosures rounded outward.
Json to_json(const Value&);

/// The bindings that the text of a word carries after `where`: "omega = 1/2", "f@lat(alpha) = cos(alpha/2)".
std::vector<std::string> word_bindings(const WordValue& word);

/// "error[W03]: …" with place, source line, caret and help; no newline at the end. A code without an entry prints as X02.
std::string to_text(const ProgramError&, bool colour);
Json to_json(const ProgramError&);
std::string warning_text(const std::string& message, bool colour);
Json warning_json(const std::string& message);

/// An error outside any program text.
ProgramError make_error(ErrorKind kind, const std::string& code, const std::string& message, const std::string& help = {});
/// What is being handled, as a ProgramError; only inside a catch block. Lost memory is a limit, anything unknown an internal
/// error.
ProgramError current_error();

struct CodeEntry {
  const char* symbol;  // "E_P_DUAL"
  const char* code;    // "W03"
  const char* title;
  const char* story;  // what `udcp --explain W03` prints
};
/// The entry of a symbolic or printed code; null if there is none.
const CodeEntry* find_code(const std::string& symbol_or_code);
/// The whole table, sorted by code.
std::span<const CodeEntry> codes();

/// 2 for input, word and not_exact; 4 limit; 5 file; 130 interrupted; 70 internal.
int exit_code(ErrorKind kind);
int exit_code(Outcome outcome);

}  // namespace udcp
