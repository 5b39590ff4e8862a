// Scopes and type names; values themselves are plain data.
#include "interpreter/value.h"

namespace udcp {

std::string type_name(const Value& value) {
  struct Names {
    std::string operator()(const Nothing&) const { return "nothing"; }
    std::string operator()(const NumberValue&) const { return "number"; }
    std::string operator()(const Boolean&) const { return "boolean"; }
    std::string operator()(const TextValue&) const { return "text"; }
    std::string operator()(const ListValue&) const { return "list"; }
    std::string operator()(const WordValue&) const { return "word"; }
    std::string operator()(const CurveValue&) const { return "curve"; }
    std::string operator()(const MeshValue&) const { return "mesh"; }
    std::string operator()(const MatrixValue&) const { return "matrix"; }
    std::string operator()(const FunctionValue&) const { return "function"; }
    std::string operator()(const ReportValue& report) const {
      return report.claim ? "claim" : report.surface ? "surface" : "report";
    }
  };
  return std::visit(Names{}, value.data);
}

Environment::Found Environment::lookup(const std::string& name) const {
  for (const Environment* scope = this; scope; scope = scope->outer.get()) {
    const auto found = scope->names.find(name);
    if (found != scope->names.end()) return {&found->second, scope->frame};
  }
  return {};
}

Environment::~Environment() {
  names.clear();  // functions in here hold the outer scope too; it must have one owner left below
  while (outer && outer.use_count() == 1) {
    auto& last = const_cast<Environment&>(*outer);  // no scope is created const
    last.names.clear();
    outer = std::shared_ptr<const Environment>(std::move(last.outer));
  }
}

}  // namespace udcp
