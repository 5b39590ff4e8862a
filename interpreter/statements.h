// The execution of statements. Session owns the state that outlives a run; a Runner lives for one run.
#pragma once

#include "interpreter/expressions.h"

namespace udcp {

class Runner {
 public:
  Runner(CallContext context, Outcome& outcome) : context_(std::move(context)), outcome_(outcome) {}

  /// Parses and executes; throws ProgramError with the text it belongs to. `done` hears every statement that ran.
  void run(const SourcePtr& source, const std::filesystem::path& folder,
           const std::function<void(const grammar::Statement&)>& done);

  [[nodiscard]] const std::shared_ptr<const Environment>& scope() const { return context_.scope; }
  [[nodiscard]] const Value& last() const { return last_; }      // of the last expression, for _
  [[nodiscard]] const Value& result() const { return result_; }  // of the last statement
  [[nodiscard]] bool has_last() const { return has_last_; }
  /// The value that _ stands for at the start.
  void remember(const Value& value) {
    last_ = value;
    has_last_ = true;
  }

 private:
  void execute(const grammar::Statement&);
  void execute_body(const std::vector<grammar::Statement>&, const std::string& name, Value value);
  void on(const grammar::Define&, grammar::Span);
  void on(const grammar::Evaluate&, grammar::Span);
  void on(const grammar::Print&, grammar::Span);
  void on(const grammar::Sweep&, grammar::Span);
  void on(const grammar::Animate&, grammar::Span);
  void on(const grammar::Assert&, grammar::Span);
  void on(const grammar::Claim&, grammar::Span);
  void on(const grammar::Verify&, grammar::Span);
  void on(const grammar::Use&, grammar::Span);
  void on(const grammar::Set&, grammar::Span);
  void define(const std::string& name, Value value);
  void settle(Value decision);
  void refute(const grammar::Expr& condition, grammar::Span, const std::string& details, const Json& witness);
  void save_frames(const AnimationFrames&);

  CallContext context_;
  Outcome& outcome_;
  Value last_, result_;
  bool has_last_ = false;
  std::vector<std::filesystem::path> files_;  // being used right now, outermost first
};

}  // namespace udcp
