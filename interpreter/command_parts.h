// The actions behind the command line, each on its own so that command.cpp stays a list. They throw; command() catches.
#pragma once

#include <iosfwd>
#include <string>

#include "interpreter/command_line.h"
#include "interpreter/console.h"
#include "interpreter/interrupt.h"

namespace udcp {

/// Programs above this size are refused, as the grammar does.
inline constexpr std::size_t max_program_bytes = std::size_t{16} << 20;

/// The text of a program. Throws ProgramError of kind file: E_FILE_OPEN (missing, a folder, unreadable), E_PROGRAM_SIZE,
/// E_NOT_PROGRAM (a mesh, a picture, any binary file).
std::string read_program(const std::string& file);
std::string read_program(std::istream& in, const std::string& name);

/// Throws ProgramError unless the text is one expression or word: for text that must not define, print or save anything.
void check_expression(const std::string& text, const std::string& name);

/// udcp apply: reads, refines, writes.
void apply_to_file(const CommandLine& line, Session& session, Console& console, std::istream& in, const std::atomic<bool>& stop);
/// udcp fmt: false if --check found a file that is not in canonical form.
bool format_programs(const CommandLine& line, Console& console, std::istream& in);
/// A program that proves one claim or verifies one certificate, made from its syntax tree so that no name can break out of its
/// quotes.
std::string claim_program(const CommandLine& line);
std::string verify_program(const std::string& certificate);
/// What --explain prints. Throws UsageError for an unknown code.
std::string explain(const std::string& code);

}  // namespace udcp
