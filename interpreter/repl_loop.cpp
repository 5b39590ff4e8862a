// Statements over several lines, and the :commands.
#include "interpreter/repl_loop.h"

#include <chrono>
#include <cstdio>

#include "files/geometry_file.h"
#include "grammar/parse.h"
#include "interpreter/command_parts.h"

namespace udcp {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

/// A file name as it is, or between quotes.
std::string unquoted(const std::string& text) {
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') return text.substr(1, text.size() - 2);
  return text;
}

bool is_unfinished(const std::string& text) {
  try {
    grammar::parse(text);
  } catch (const grammar::SyntaxError& error) {
    return error.incomplete;
  }
  return false;
}

ProgramError mistake(const std::string& message, const std::string& help = {}) {
  return make_error(ErrorKind::input, "E_REPL", message, help);
}

std::string settings_text(const Settings& s) {
  return "precision = " + std::to_string(s.precision) + "\nmax_faces = " + std::to_string(s.max_faces) +
         "\nseed = " + std::to_string(s.seed) + "\nthreads = " + std::to_string(s.threads);
}

}  // namespace

ReplLoop::ReplLoop(Session& session, Console& console, std::function<void()> after_error)
    : session_(session), console_(console), after_error_(std::move(after_error)) {
  session_.output() = console_.output();
  session_.output().value = [this](const Value& value) {
    if (muted_) return;
    const auto* word = value.as<WordValue>();
    if (word == nullptr || console_.options().json) return console_.value(value);
    console_.text(describe_word(*word, session_));
  };
}

const char* ReplLoop::prompt() const { return pending_.empty() ? "udcp> " : "....> "; }

bool ReplLoop::line(const std::string& text) {
  const std::string content = trimmed(text);
  if (pending_.empty() && content.empty()) return true;
  if (pending_.empty() && content.front() == ':') return command(content);
  pending_ += text + "\n";
  if (!content.empty() && is_unfinished(pending_)) return true;
  const std::string program = std::move(pending_);
  pending_.clear();
  guarded([&] { run(program, "<input>"); });
  return true;
}

void ReplLoop::run(const std::string& text, const std::string& name, const std::filesystem::path& folder) {
  session_.run(text, name, folder);
  console_.erase_progress();
}

void ReplLoop::guarded(const std::function<void()>& action) {
  try {
    action();
  } catch (...) {
    console_.error(current_error());
    if (after_error_) after_error_();
  }
}

bool ReplLoop::command(const std::string& text) {
  const std::size_t blank = text.find_first_of(" \t");
  const std::string name = text.substr(0, blank);
  const std::string rest = blank == std::string::npos ? "" : trimmed(text.substr(blank));
  if (name == ":quit" || name == ":q") return false;
  guarded([&] {
    if (name == ":help") {
      const std::string help = help_topic(rest);
      if (help.empty())
        throw mistake("there is no help on '" + rest + "'", "topics: functions, atoms, statements, codes, a function, a code");
      console_.text(help);
    } else if (name == ":type") {
      show_type(rest);
    } else if (name == ":load") {
      load(unquoted(rest));
    } else if (name == ":save") {
      save(unquoted(rest));
    } else if (name == ":time") {
      time(rest);
    } else if (name == ":set") {
      set(rest);
    } else if (name == ":undo") {
      undo();
    } else {
      std::string known;
      for (const ReplCommand& each : repl_commands()) known += std::string(known.empty() ? "" : " ") + each.name;
      throw mistake("there is no command " + name, "commands: " + known);
    }
  });
  return true;
}

void ReplLoop::show_type(const std::string& expression) {
  if (expression.empty()) throw mistake(":type needs an expression", "for example :type (UCP)*");
  check_expression(expression, "<input>");
  muted_ = true;
  Value value;
  try {
    value = session_.run(expression, "<input>");
  } catch (...) {
    muted_ = false;
    throw;
  }
  muted_ = false;
  console_.text(type_name(value));
}

void ReplLoop::load(const std::string& file) {
  if (file.empty()) throw mistake(":load needs a file", "for example :load tour.udcp");
  run(read_program(file), file, std::filesystem::path(file).parent_path());
}

void ReplLoop::save(const std::string& file) {
  if (file.empty()) throw mistake(":save needs a file", "for example :save session.udcp");
  write_file(file, session_.program());
  console_.text("saved to " + file);
}

void ReplLoop::time(const std::string& statement) {
  if (statement.empty()) throw mistake(":time needs a statement", "for example :time cube() |> catmull_clark^6");
  const auto begin = std::chrono::steady_clock::now();
  run(statement, "<input>");
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  char text[64];
  std::snprintf(text, sizeof text, "time: %.3f s", seconds.count());
  console_.text(text);
}

void ReplLoop::set(const std::string& assignment) {
  if (assignment.empty()) return console_.text(settings_text(session_.settings()));
  run("set " + assignment, "<input>");
}

void ReplLoop::undo() {
  if (!session_.undo()) throw mistake("there is nothing to undo");
  console_.text("undone");
}

}  // namespace udcp
