// The interactive loop: lines from the editor to ReplLoop, Ctrl-C to the running computation.
#include "interpreter/repl.h"

#include <unistd.h>

#include <clocale>
#include <iostream>

#include "interpreter/interrupt.h"
#include "interpreter/repl_editor.h"
#include "interpreter/repl_loop.h"

namespace udcp {
namespace {

/// libedit reads UTF-8 only under a locale that says so. Numbers are never touched: LC_NUMERIC stays "C".
void use_utf8() {
  if (std::setlocale(LC_CTYPE, "") == nullptr || MB_CUR_MAX == 1) std::setlocale(LC_CTYPE, "C.UTF-8");
}

LineEditor::Complete completer(const Session& session) {
  return [&session](const std::string& line, std::size_t cursor) {
    return LineEditor::Completion{completion_begin(line, cursor), completions(session, line, cursor)};
  };
}

}  // namespace

int repl(Session& session, const ReplOptions& options) {
  use_utf8();
  InterruptGuard interrupt(session);
  Console console(std::cout, std::cerr, {options.json, session.settings().quiet, options.colour, isatty(STDERR_FILENO) == 1});
  console.on_failure = [&session] { session.interrupt(); };
  ReplLoop loop(session, console, [&interrupt] { interrupt.clear(); });
  LineEditor editor(history_file(), completer(session));
  std::string line;
  while (!console.failed()) {
    if (const std::string problem = editor.history_problem(); !problem.empty()) console.warning("no history is kept: " + problem);
    switch (editor.read(loop.prompt(), line)) {
      case LineEditor::Read::interrupted:
        loop.abandon();
        continue;
      case LineEditor::Read::end:
        std::cout << std::endl;
        return 0;
      case LineEditor::Read::line:
        break;
    }
    interrupt.clear();
    if (!loop.line(line)) return 0;
  }
  return 0;
}

}  // namespace udcp
