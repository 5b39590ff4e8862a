// Equality of values. A double is never equal to anything: what was rounded is compared with approx().
#include "interpreter/compare.h"

#include <cmath>

#include "interpreter/evaluate.h"
#include "interpreter/report.h"
#include "interpreter/words.h"

namespace udcp {

namespace {

/// Compares structures; the two policies decide about numbers.
class Comparer {
 public:
  explicit Comparer(const double* tolerance) : tolerance_(tolerance) {}

  Comparison values(const Value& a, const Value& b) {
    const auto *p = a.as<ReportValue>(), *q = b.as<ReportValue>();
    if (p && q && p->parts.empty() && q->parts.empty()) return decide(p->json == q->json, "the reports differ");
    const std::vector<Value>*x = items(a), *y = items(b);
    if (x && y) return lists(*x, *y);
    if (a.data.index() != b.data.index()) return {false, "the left side is " + noun(a) + ", the right side is " + noun(b)};
    return std::visit([&](const auto& left) { return same_kind(left, b); }, a.data);
  }

 private:
  static std::string noun(const Value& v) {
    const std::string name = type_name(v);
    return name == "nothing" ? name : "a " + name;
  }
  static Comparison decide(bool equal, std::string difference) {
    return equal ? Comparison{} : Comparison{false, std::move(difference)};
  }

  static const std::vector<Value>* items(const Value& v) {
    if (const auto* list = v.as<ListValue>()) return &list->items;
    const auto* report = v.as<ReportValue>();
    return report && !report->parts.empty() ? &report->parts : nullptr;
  }

  Comparison lists(const std::vector<Value>& a, const std::vector<Value>& b) {
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
      const Comparison c = values(a[i], b[i]);
      if (!c.equal) return {false, "item " + std::to_string(i) + ": " + c.difference};
    }
    return decide(a.size() == b.size(),
                  "the left side has " + std::to_string(a.size()) + " items, the right side has " + std::to_string(b.size()));
  }

  Comparison numbers(const NumberValue& a, const NumberValue& b) {
    const bool measured = std::holds_alternative<double>(a.value) || std::holds_alternative<double>(b.value);
    if (tolerance_) {
      const double x = quantity<double>(a).value(), y = quantity<double>(b).value();
      return decide(std::abs(x - y) <= *tolerance_, to_text(Value{a}) + " and " + to_text(Value{b}));
    }
    if (measured)
      throw Error(ErrorKind::not_exact, "E_NOT_EXACT", "a number in double cannot be compared exactly",
                  "write approx(a, b, tolerance), or use exact shapes (exact = yes)");
    return decide(compare(a, b) == 0, to_text(Value{a}) + " and " + to_text(Value{b}));
  }

  static NumberValue wrap(const Algebraic& value) { return exact_number(value); }
  static NumberValue wrap(const Interval& value) { return {value}; }
  static NumberValue wrap(double value) { return {value}; }

  template <class S, class T>
  Comparison tables(const Points<S>& a, const Points<T>& b, const std::string& row, const std::string& column) {
    if (a.rows() != b.rows() || a.cols() != b.cols())
      return {false, "the left side has " + std::to_string(a.rows()) + " by " + std::to_string(a.cols()) +
                         " numbers, the right side " + std::to_string(b.rows()) + " by " + std::to_string(b.cols())};
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
      for (Eigen::Index j = 0; j < a.cols(); ++j) {
        const Comparison c = numbers(wrap(a(i, j)), wrap(b(i, j)));
        if (!c.equal)
          return {false, row + " " + std::to_string(i) + ", " + column + " " + std::to_string(j) + ": " + c.difference};
      }
    }
    return {};
  }

  Comparison same_kind(const Nothing&, const Value&) { return {}; }
  Comparison same_kind(const NumberValue& a, const Value& b) { return numbers(a, *b.as<NumberValue>()); }
  Comparison same_kind(const Boolean& a, const Value& b) {
    return decide(a.value == b.as<Boolean>()->value, a.value ? "yes and no" : "no and yes");
  }
  Comparison same_kind(const TextValue& a, const Value& b) {
    return decide(a.value == b.as<TextValue>()->value, "\"" + a.value + "\" and \"" + b.as<TextValue>()->value + "\"");
  }
  Comparison same_kind(const ListValue& a, const Value& b) { return lists(a.items, b.as<ListValue>()->items); }
  Comparison same_kind(const WordValue& a, const Value& b) {
    return decide(same_word(a, *b.as<WordValue>()), "the words differ: " + a.source + " and " + b.as<WordValue>()->source);
  }
  Comparison same_kind(const CurveValue& a, const Value& b) {
    return std::visit(
        [&](const auto& x, const auto& y) {
          if (x.closed != y.closed) return Comparison{false, "one curve is closed, the other is open"};
          return tables(x.points, y.points, "point", "coordinate");
        },
        a.shape, b.as<CurveValue>()->shape);
  }
  Comparison same_kind(const MeshValue& a, const Value& b) {
    return std::visit(
        [&](const auto& x, const auto& y) {
          if (x.mesh->face_begin != y.mesh->face_begin || x.mesh->vertex != y.mesh->vertex)
            return Comparison{false, "the meshes have different faces"};
          for (int e = 0; e < x.mesh->edges(); ++e)
            if (x.tags.of_edge(e) != y.tags.of_edge(e))
              return Comparison{false, "edge " + std::to_string(e) + " has different tags"};
          for (int v = 0; v < x.mesh->vertices(); ++v)
            if (x.tags.is_corner(v) != y.tags.is_corner(v))
              return Comparison{false, "vertex " + std::to_string(v) + " is a corner in one of them"};
          return tables(x.points, y.points, "point", "coordinate");
        },
        a.shape, b.as<MeshValue>()->shape);
  }
  Comparison same_kind(const MatrixValue& a, const Value& b) {
    return std::visit([&](const auto& x, const auto& y) { return tables(x, y, "row", "column"); }, a.entries,
                      b.as<MatrixValue>()->entries);
  }
  Comparison same_kind(const FunctionValue&, const Value&) {
    throw Error(ErrorKind::word, "E_TYPE", "functions cannot be compared", "compare what they give for some arguments");
  }
  Comparison same_kind(const ReportValue& a, const Value& b) {
    return decide(a.json == b.as<ReportValue>()->json, "the reports differ");
  }

  const double* tolerance_;
};

}  // namespace

Comparison compare_values(const Value& a, const Value& b) { return Comparer(nullptr).values(a, b); }

Comparison compare_approximately(const Value& a, const Value& b, double tolerance) { return Comparer(&tolerance).values(a, b); }

}  // namespace udcp
