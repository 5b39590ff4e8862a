// Statements, and the test of one patch.
#include "proofs/offset_statements.h"

namespace udcp {
namespace {

std::string short_text(const Algebraic& value) {
  const std::string exact = value.to_string();
  return exact.size() <= 40 ? exact : value.enclosure().upper_decimal(7) + " (rounded up)";
}

/// "(6 vertices, 8 faces, digest 0123456789abcdef)"
std::string name_of(const Json& data, const char* rows) {
  std::string all = data["faces"].dump() + data[rows].dump();
  if (data.contains("points") && data.contains("vectors")) all += data["points"].dump();
  return "(" + std::to_string(data[rows].size()) + " vertices, " + std::to_string(data["faces"].size()) + " faces, digest " +
         digest(all) + ")";
}

}  // namespace

std::string contraction_claim(int valence, LocalSet set) {
  return "the edge iteration for offsets of Loop surfaces, at vertices of valence " + std::to_string(valence) + " with " +
         (set == LocalSet::star ? "their star of regular neighbours" : "a regular partner") +
         ", has coefficients whose moduli sum to less than 1";
}

std::string contraction_statement(int valence, LocalSet set, const Algebraic& bound) {
  return contraction_claim(valence, set) + ", at most " + short_text(bound);
}

std::string definite_statement(int valence, const Algebraic& bound) {
  return "the system for offsets of Loop surfaces on closed triangle meshes is positive definite where valences are " +
         std::to_string(valence) + ", and such vertices keep the eigenvalues of its limit matrix at or above " +
         short_text(bound);
}

std::string error_statement(const Json& data, const Rational& distance, bool full, const Rational& bound) {
  const std::string name = name_of(data, "vectors");
  if (!full)
    return "the Loop surface delta with the given control vectors " + name + " has ||delta| - " + distance.to_string() +
           "| <= " + bound.to_string() + " everywhere";
  return "the Loop surfaces S and delta with the given control points and vectors " + name + " have |delta - " +
         distance.to_string() + " n| <= " + bound.to_string() + " everywhere, n the unit normal of S";
}

std::string embedded_statement(const Json& data) {
  return "the Loop surface with the given control points " + name_of(data, "points") + " does not meet itself";
}

Points<Interval> weighted_rows(const Points<Interval>& a, const Points<Interval>& b) {
  Points<Interval> result = Points<Interval>::Zero(a.rows(), b.cols());
  for (int i = 0; i < a.rows(); ++i)
    for (int j = 0; j < a.cols(); ++j)
      if (!is_zero(a(i, j))) add(result, i, a(i, j), b, j);
  return result;
}

OffsetErrorTest::OffsetErrorTest(const Mesh& mesh, const Rational& distance, bool full, const Rational& bound)
    : distance_(distance), bound_(bound), full_(full), steps_(enclosed_steps(mesh)) {
  for (const int n : valences_of(mesh)) {
    if (!full || n == 6) continue;
    corners_.emplace(n, CornerAnalysis<Interval>(n));
    near_corners_.emplace(n, CornerAnalysis<double>(n));
  }
}

template <class S>
bool OffsetErrorTest::is_within(const Points<S>& net, const S& distance, const S& bound, const Corners<S>& corners) const {
  const Points<S> s = net.leftCols(3), d = net.rightCols(3);
  const bool regular = net.rows() == 12;
  if (!full_) return length_error(regular ? length_by_bernstein(d) : length_by_hull(d), distance) <= bound;
  if (regular) {
    const std::optional<NormalCone<S>> cone = regular_cone(s);
    if (cone && error_in_cone(*cone, bezier_points(d), distance) <= bound) return true;  // cheaper, and often enough
    const std::optional<S> error = regular_error(s, d, distance);
    return error && *error <= bound;
  }
  const std::optional<NormalCone<S>> cone = corners.at(static_cast<int>(net.rows()) - 6).cone(s);
  return cone && error_in_cone(*cone, d, distance) <= bound;
}

bool OffsetErrorTest::accepts(const Points<Interval>& net) const {
  return is_within(net, Interval(distance_), Interval(bound_), corners_);
}

bool OffsetErrorTest::likely(const Points<Interval>& net) const {
  Points<double> near(net.rows(), net.cols());
  for (Eigen::Index k = 0; k < net.size(); ++k) near.data()[k] = net.data()[k].midpoint();
  return is_within(near, distance_.to_double(), bound_.to_double(), near_corners_);
}

std::array<Points<Interval>, 4> OffsetErrorTest::children(const Points<Interval>& net) const {
  const PatchStep<Interval>& step = steps_.at(static_cast<int>(net.rows()) - 6);
  return {weighted_rows(step.inner, net), weighted_rows(step.regular[0], net), weighted_rows(step.regular[1], net),
          weighted_rows(step.regular[2], net)};
}

}  // namespace udcp
