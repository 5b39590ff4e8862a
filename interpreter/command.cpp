// The command: options to actions, every error to a message and an exit code. The only place that maps kinds of errors to exit
// codes.
#include "interpreter/command.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>

#include "interpreter/command_parts.h"
#include "interpreter/repl.h"

namespace udcp {
namespace {

bool is_terminal(const std::ostream& stream) {
  return (&stream == &std::cout && isatty(STDOUT_FILENO) == 1) || (&stream == &std::cerr && isatty(STDERR_FILENO) == 1);
}

bool wants_colour(const CommandLine& line, const std::ostream& err) {
  if (line.colour != "auto") return line.colour == "always";
  const char* refused = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  if (refused != nullptr && *refused != '\0') return false;
  return is_terminal(err) && terminal != nullptr && std::strcmp(terminal, "dumb") != 0;
}

int run_text(Session& session, const std::string& text, const std::string& name, const std::filesystem::path& folder) {
  session.run(text, name, folder);
  return exit_code(session.outcome());
}

int run_action(const CommandLine& line, Session& session, Console& console, std::istream& in, const InterruptGuard& interrupt) {
  switch (line.action) {
    case Action::apply:
      apply_to_file(line, session, console, in, interrupt.stop());
      return 0;
    case Action::prove:
      return run_text(session, claim_program(line), "<command line>", {});
    case Action::verify:
      return run_text(session, verify_program(line.files[0]), "<command line>", {});
    default:
      break;
  }
  if (line.code) return run_text(session, *line.code, "<command line>", {});
  if (line.files.empty() || line.files[0] == "-") return run_text(session, read_program(in, "standard input"), "<stdin>", {});
  const std::string& file = line.files[0];
  return run_text(session, read_program(file), file, std::filesystem::path(file).parent_path());
}

/// Actions that need no session, hence no prelude.
bool run_without_session(const CommandLine& line, Console& console, std::istream& in, int& code) {
  code = 0;
  switch (line.action) {
    case Action::help:
      console.out() << help_text();
      break;
    case Action::version:
      console.text(version_text());
      break;
    case Action::explain:
      console.text(explain(line.explain));
      break;
    case Action::format:
      code = format_programs(line, console, in) ? 0 : 1;
      break;
    default:
      return false;
  }
  console.flush();
  return true;
}

/// Results that could not be written: a reader that went away (head, less) is no error worth a message.
int output_failure(Console& console) {
  if (console.failure() == EPIPE) return 128 + SIGPIPE;
  console.error(make_error(ErrorKind::file, "E_OUTPUT",
                           std::string("standard output cannot be written: ") +
                               (console.failure() != 0 ? std::strerror(console.failure()) : "the stream is closed")));
  return exit_code(ErrorKind::file);
}

bool is_interactive(const CommandLine& line, const std::istream& in) {
  return line.action == Action::program && !line.code && line.files.empty() && &in == &std::cin && isatty(STDIN_FILENO) == 1;
}

int run_session(const CommandLine& line, Console& console, std::istream& in) {
  Session session(line.settings, console.output());
  session.load_prelude();
  if (is_interactive(line, in)) return repl(session, {console.options().colour, console.options().json});
  InterruptGuard interrupt(session);
  console.on_failure = [&session] { session.interrupt(); };
  try {
    const int code = run_action(line, session, console, in, interrupt);
    console.erase_progress();
    return console.failed() ? output_failure(console) : code;
  } catch (...) {
    console.erase_progress();
    if (console.failed()) return output_failure(console);
    throw;
  }
}

int run_command(const CommandLine& line, Console& console, std::istream& in) {
  int code = 0;
  if (run_without_session(line, console, in, code)) return console.failed() ? output_failure(console) : code;
  return run_session(line, console, in);
}

int report_failure(Console& console) {
  try {
    throw;
  } catch (const UsageError& error) {
    console.error(make_error(ErrorKind::input, "E_USAGE", error.what(), "udcp --help shows what can be written"));
    return exit_code(ErrorKind::input);
  } catch (...) {
    const ProgramError error = current_error();
    console.error(error);
    if (error.code == "E_UNDECIDED") return exit_code(Outcome::undecided);
    return error.syntax ? exit_code(ErrorKind::input) : exit_code(error.kind);
  }
}

/// Before the command line is understood, --json among its words decides how its own errors look.
bool asks_for_json(int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--json") == 0) return true;
  }
  return false;
}

}  // namespace

int command(int argc, const char* const* argv, std::istream& in, std::ostream& out, std::ostream& err) {
  CommandLine line;
  try {
    line = parse_command_line(argc, argv);
  } catch (...) {
    line.json = asks_for_json(argc, argv);
    Console console(out, err, {line.json, false, wants_colour(line, err), false});
    return report_failure(console);
  }
  Console console(out, err, {line.json, line.settings.quiet, wants_colour(line, err), is_terminal(err)});
  try {
    return run_command(line, console, in);
  } catch (...) {
    return report_failure(console);
  }
}

}  // namespace udcp
