// libedit behind a small class. Ctrl-C is an ordinary key while a line is edited (the terminal makes no signals in edit mode), so
// that none can arrive in the middle of libedit; during a computation it is a signal again. Ctrl-Z is passed on by hand.
#include "interpreter/repl_editor.h"

#include <fcntl.h>
#include <histedit.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace udcp {
namespace {

namespace fs = std::filesystem;

std::string failure(const fs::path& path, const char* what, const char* reason) {
  std::string text = "'";
  text.append(path.string()).append("' ").append(what).append(reason);
  return text;
}

/// Creates the folder (0700) and the file (0600) where they are missing; empty if the file can be written.
std::string prepare(const fs::path& file) {
  std::error_code error;
  const fs::path folder = file.parent_path();
  if (!folder.parent_path().empty()) fs::create_directories(folder.parent_path(), error);
  if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) return failure(folder, "cannot be made: ", std::strerror(errno));
  const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor < 0) return failure(file, "cannot be written: ", std::strerror(errno));
  close(descriptor);
  return {};
}

std::string common_prefix(const std::vector<std::string>& words) {
  std::string prefix = words.front();
  for (const std::string& word : words) {
    const auto end = std::mismatch(prefix.begin(), prefix.end(), word.begin(), word.end()).first;
    prefix.erase(end, prefix.end());
  }
  return prefix;
}

}  // namespace

fs::path history_file() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state != nullptr && fs::path(state).is_absolute()) return fs::path(state) / "udcp" / "history";
  const char* home = std::getenv("HOME");
  return home != nullptr && *home != '\0' ? fs::path(home) / ".local" / "state" / "udcp" / "history" : fs::path();
}

struct LineEditor::State {
  std::FILE* screen = stdout;
  EditLine* edit = nullptr;
  History* history = nullptr;
  fs::path file;
  std::string problem;
  std::string prompt;
  Complete complete;
  bool interrupted = false;

  static State& of(EditLine* edit) {
    void* state = nullptr;
    el_get(edit, EL_CLIENTDATA, &state);
    return *static_cast<State*>(state);
  }
  static char* show_prompt(EditLine* edit) { return of(edit).prompt.data(); }

  static unsigned char on_interrupt(EditLine* edit, int) {
    State& state = of(edit);
    state.interrupted = true;
    std::fputs("^C\r\n", state.screen);
    std::fflush(state.screen);
    return CC_NEWLINE;
  }

  static unsigned char on_suspend(EditLine*, int) {
    std::raise(SIGTSTP);  // libedit's own handler leaves and enters edit mode around it
    return CC_REDISPLAY;
  }

  static unsigned char on_tab(EditLine* edit, int) {
    State& state = of(edit);
    const LineInfo* info = el_line(edit);
    const std::string line(info->buffer, static_cast<std::size_t>(info->lastchar - info->buffer));
    const auto cursor = static_cast<std::size_t>(info->cursor - info->buffer);
    const Completion found = state.complete(line, cursor);
    if (found.words.empty()) return CC_ERROR;
    const std::string prefix = common_prefix(found.words);
    const std::size_t typed = cursor - found.begin;
    if (prefix.size() > typed) return el_insertstr(edit, prefix.c_str() + typed) == 0 ? CC_REFRESH : CC_ERROR;
    if (found.words.size() == 1) return CC_ERROR;  // complete already
    state.list(found.words);
    return CC_REDISPLAY;
  }

  /// Below the line, in columns.
  void list(const std::vector<std::string>& words) const {
    constexpr std::size_t most = 120, screen_width = 100;
    std::size_t width = 0, at = 0;
    for (const std::string& word : words) width = std::max(width, word.size() + 2);
    std::fputs("\r\n", screen);
    for (std::size_t i = 0; i < std::min(words.size(), most); ++i) {
      if (at + width > screen_width) std::fputs("\r\n", screen);
      if (at + width > screen_width) at = 0;
      std::fprintf(screen, "%-*s", static_cast<int>(width), words[i].c_str());
      at += width;
    }
    std::fputs(words.size() > most ? "\r\n(more)\r\n" : "\r\n", screen);
    std::fflush(screen);
  }

  void keep(const std::string& line) {
    HistEvent event;
    history_function(history, &event, H_ENTER, line.c_str());
    if (problem.empty() && !file.empty() && history_function(history, &event, H_SAVE, file.c_str()) < 0) {
      problem = failure(file, "cannot be written", "");
      file.clear();
    }
  }

  // `history` is a member here and a function of libedit.
  static constexpr auto history_function = &::history;
};

LineEditor::LineEditor(fs::path history, Complete complete) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.complete = std::move(complete);
  if (isatty(STDOUT_FILENO) != 1) s.screen = stderr;
  s.history = history_init();
  HistEvent event;
  State::history_function(s.history, &event, H_SETSIZE, 1000);
  State::history_function(s.history, &event, H_SETUNIQUE, 1);
  if (!history.empty()) s.problem = prepare(history);
  if (s.problem.empty()) s.file = std::move(history);
  if (!s.file.empty()) State::history_function(s.history, &event, H_LOAD, s.file.c_str());

  s.edit = el_init("udcp", stdin, s.screen, stderr);
  el_set(s.edit, EL_CLIENTDATA, &s);
  el_set(s.edit, EL_PROMPT, &State::show_prompt);
  el_set(s.edit, EL_EDITOR, "emacs");
  el_set(s.edit, EL_SIGNAL, 1);
  el_set(s.edit, EL_HIST, State::history_function, s.history);
  el_set(s.edit, EL_ADDFN, "udcp-complete", "complete the word", &State::on_tab);
  el_set(s.edit, EL_ADDFN, "udcp-interrupt", "forget the line", &State::on_interrupt);
  el_set(s.edit, EL_ADDFN, "udcp-suspend", "stop the process", &State::on_suspend);
  el_set(s.edit, EL_BIND, "^R", "em-inc-search-prev", nullptr);
  el_source(s.edit, nullptr);
  el_set(s.edit, EL_SETTY, "-d", "-isig", nullptr);
  el_set(s.edit, EL_BIND, "^I", "udcp-complete", nullptr);
  el_set(s.edit, EL_BIND, "^C", "udcp-interrupt", nullptr);
  el_set(s.edit, EL_BIND, "^Z", "udcp-suspend", nullptr);
}

LineEditor::~LineEditor() {
  el_end(state_->edit);
  history_end(state_->history);
}

LineEditor::Read LineEditor::read(const std::string& prompt, std::string& line) {
  State& s = *state_;
  s.prompt = prompt;
  s.interrupted = false;
  int count = 0;
  const char* text = el_gets(s.edit, &count);
  if (s.interrupted) return Read::interrupted;
  if (text == nullptr || count <= 0) return Read::end;
  line.assign(text, static_cast<std::size_t>(count));
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
  if (line.find_first_not_of(" \t") != std::string::npos) s.keep(line);
  return Read::line;
}

std::string LineEditor::history_problem() { return std::exchange(state_->problem, std::string()); }

}  // namespace udcp
