// The state that outlives a run, and undo as a stack of snapshots: scopes are shared and immutable, so a snapshot costs nothing.
#include "interpreter/session.h"

#include <set>

#include "grammar/print.h"
#include "interpreter/prelude.h"
#include "interpreter/statements.h"

namespace udcp {

struct Session::State {
  struct Snapshot {
    std::shared_ptr<const Environment> scope;
    Settings settings;
    std::size_t statements = 0;
  };

  Settings settings;
  Output output;
  std::shared_ptr<std::atomic<bool>> stop = std::make_shared<std::atomic<bool>>(false);
  std::shared_ptr<const Environment> scope = std::make_shared<Environment>();
  Value last;
  bool has_last = false;
  Outcome outcome = Outcome::done;
  std::vector<std::string> statements;
  std::vector<Snapshot> history;
};

namespace {

std::string canonical(const grammar::Statement& statement) {
  grammar::Program program;
  program.statements.push_back(statement);
  return grammar::to_string(program);
}

}  // namespace

Session::Session(Settings settings, Output output) : state_(std::make_shared<State>()) {
  state_->settings = settings;
  state_->output = std::move(output);
}

Value Session::run(std::string_view source, const std::string& name, const std::filesystem::path& folder) {
  State& s = *state_;
  Interval::set_precision(s.settings.precision);
  const State::Snapshot before{s.scope, s.settings, s.statements.size()};
  CallContext context{s.settings, s.output, s.stop, folder, s.scope, nullptr};
  Runner runner(std::move(context), s.outcome);
  if (s.has_last) runner.remember(s.last);
  const auto keep = [&] {
    s.scope = runner.scope();
    s.has_last = runner.has_last();
    if (s.has_last) s.last = runner.last();
    if (s.scope != before.scope) s.history.push_back(before);
  };
  try {
    runner.run(std::make_shared<const SourceText>(SourceText{name, std::string(source)}), folder,
               [&](const grammar::Statement& statement) { s.statements.push_back(canonical(statement)); });
  } catch (...) {
    keep();
    throw;
  }
  keep();
  return runner.result();
}

void Session::load_prelude() {
  State& s = *state_;
  Interval::set_precision(s.settings.precision);
  Outcome outcome = Outcome::done;
  const Output silent;
  Runner runner(CallContext{s.settings, silent, s.stop, {}, s.scope, nullptr}, outcome);
  runner.run(std::make_shared<const SourceText>(SourceText{"prelude.udcp", prelude_text(), true}), {}, {});
  s.scope = runner.scope();
}

bool Session::undo() {
  State& s = *state_;
  if (s.history.empty()) return false;
  const State::Snapshot& before = s.history.back();
  s.scope = before.scope;
  s.settings = before.settings;
  s.statements.resize(before.statements);
  s.history.pop_back();
  return true;
}

void Session::interrupt() noexcept { *state_->stop = true; }
void Session::clear_interrupt() noexcept { *state_->stop = false; }
Outcome Session::outcome() const { return state_->outcome; }
const Settings& Session::settings() const { return state_->settings; }
Settings& Session::settings() { return state_->settings; }
Output& Session::output() { return state_->output; }

const Value* Session::find(const std::string& name) const {
  if (name == "_") return state_->has_last ? &state_->last : nullptr;
  return state_->scope->find(name);
}

std::vector<std::string> Session::names() const { return visible_names(*state_->scope); }

std::string Session::program() const {
  std::string text;
  for (const std::string& statement : state_->statements) {
    text += statement;
    if (text.empty() || text.back() != '\n') text += '\n';
  }
  return text;
}

}  // namespace udcp
