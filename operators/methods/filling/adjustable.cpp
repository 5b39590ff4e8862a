// Adjustable Catmull-Clark. The refinement rules are those of the word; closed forms here are what the word's eigenvectors are.
#include "operators/methods/filling/adjustable.h"

#include <cmath>
#include <numbers>

#include "operators/schemes.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

template <class S>
bool in_range(const S& c) {
  return c >= S(0) && c <= S(1);
}

[[noreturn]] void out_of_range(const std::string& where, const std::string& value) {
  throw Error(ErrorKind::input, "E_ADJUSTABLE_C", "c = " + value + where + " is not between 0 and 1",
              "c = 1/2 is Catmull-Clark, smaller values stay closer to the mesh");
}

template <class S>
S tangent_factor(const S& c, TangentFactor tangents) {
  return tangents == TangentFactor::limit ? S(S(1) / S(2)) : S(c * (S(2) - c) / (S(1) + c));
}

}  // namespace

namespace schemes {

Word adjustable(const Rational& c) {
  if (!in_range(c)) out_of_range("", c.to_string());
  Word word;
  if (c.is_zero()) {
    word.tail.emplace_back();
    return word;
  }
  word = catmull_clark();
  word.tail[1].f = Directional<KernelPtr>::all(constant((Rational(1) - c) / c));
  validate(word);
  return word;
}

}  // namespace schemes

template <class S>
AdjustableLimit<S> adjustable_limit(const std::type_identity_t<S>& c, int valence) {
  const S n(valence), sum = n + S(8) * c + S(4) * c * c;
  return {n / sum, S(8) * c / (n * sum), S(4) * c * c / (n * sum)};
}

double adjustable_eigenvalue(double c, int valence, int frequency, bool larger) {
  const double s = 3 - c * (1 - std::cos(2 * std::numbers::pi * frequency / valence));
  const double large = (s + std::sqrt(s * s - 8 * (1 - c))) / 8;
  return larger ? large : (1 - c) / (8 * large);
}

double adjustable_cup_eigenvalue(double c, int valence) {
  const double sum = 0.75 - c * (4 - c) / valence, product = (1 - c) / 8 - c * (1 - c) * (2 - c) / (2 * valence);
  return (sum + std::sqrt(sum * sum - 4 * product)) / 2;
}

std::array<AdjustableTangent, 2> adjustable_tangents(double c, int valence) {
  const double kappa = c / (8 * adjustable_eigenvalue(c, valence, 1) - 2), step = 2 * std::numbers::pi / valence;
  std::array<AdjustableTangent, 2> result;
  for (int i = 0; i < valence; ++i) {
    const double here = step * i, next = step * (i + 1);
    result[0].edge.push_back(std::cos(here));
    result[1].edge.push_back(std::sin(here));
    result[0].diagonal.push_back(kappa * (std::cos(here) + std::cos(next)));
    result[1].diagonal.push_back(kappa * (std::sin(here) + std::sin(next)));
  }
  return result;
}

template <class S>
Points<S> segment_matrix(const std::type_identity_t<S>& c, TangentFactor tangents) {
  const S lambda = tangent_factor<S>(c, tangents), side = c / (S(2) * (S(1) + c)), middle = S(1) / (S(1) + c);
  // Rows: position and tangent at both ends.
  Points<S> ends = Points<S>::Zero(4, 4), hermite(4, 4);
  for (int end = 0; end < 2; ++end) {
    ends(2 * end, end) = ends(2 * end, end + 2) = side;
    ends(2 * end, end + 1) = middle;
    ends(2 * end + 1, end) = -lambda;
    ends(2 * end + 1, end + 2) = lambda;
  }
  constexpr int weights[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {-3, -2, 3, -1}, {2, 1, -2, 1}};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) hermite(i, j) = S(weights[i][j]);
  return hermite * ends;
}

namespace {

// The weights of position and derivative on three points in a row.
template <class S>
struct KnotRule {
  std::array<S, 3> position, derivative;
};
template <class S>
KnotRule<S> knot_rule(const S& c, TangentFactor tangents) {
  const S lambda = tangent_factor<S>(c, tangents), side = c / (S(2) * (S(1) + c));
  return {{side, S(1) / (S(1) + c), side}, {-lambda, S(0), lambda}};
}

// The sum of a[i] b[j] net[x + i][y + j] as row `to` of `out`.
template <class S>
void tensor(const std::array<S, 3>& a, const std::array<S, 3>& b, const Points<S>& net, int x, int y, Points<S>& out, int to) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) add(out, to, S(a[at(i)] * b[at(j)]), net, 4 * (x + i) + y + j);
}

}  // namespace

template <class S>
Points<S> hybrid_patch(const Points<S>& net, const std::array<S, 4>& c, TangentFactor tangents) {
  Points<S> result = Points<S>::Zero(16, net.cols());
  for (int x = 0; x < 2; ++x) {
    for (int y = 0; y < 2; ++y) {
      const KnotRule<S> rule = knot_rule(c[at(2 * x + y)], tangents);
      Points<S> data = Points<S>::Zero(4, net.cols());  // position, u, v and mixed derivative
      tensor(rule.position, rule.position, net, x, y, data, 0);
      tensor(rule.derivative, rule.position, net, x, y, data, 1);
      tensor(rule.position, rule.derivative, net, x, y, data, 2);
      tensor(rule.derivative, rule.derivative, net, x, y, data, 3);
      for (int j = 0; j < 2; ++j) {
        for (int k = 0; k < 2; ++k) {  // j, k steps away from the corner
          const S du = S(x == 0 ? j : -j) / S(3), dv = S(y == 0 ? k : -k) / S(3);
          const int to = 4 * (x == 0 ? j : 3 - j) + (y == 0 ? k : 3 - k);
          add(result, to, S(1), data, 0);
          add(result, to, du, data, 1);
          add(result, to, dv, data, 2);
          add(result, to, S(du * dv), data, 3);
        }
      }
    }
  }
  return result;
}

// Each rule is a polynomial in its point's own c of degree at most 2, so the step interpolates the word at c = 0, 1/2 and 1.
template <class S>
Surface<S> hybrid_step(const Surface<S>& surface, const std::string& name, const RunControl& control) {
  const auto column = surface.attributes.find(name);
  if (column == surface.attributes.end())
    throw Error(ErrorKind::input, "E_ATTRIBUTE", "the surface has no attribute '" + name + "'", "");
  for (std::size_t v = 0; v < column->second.size(); ++v)
    if (!in_range(column->second[v])) out_of_range(" at vertex " + std::to_string(v), to_text(column->second[v]));
  Surface<S> result = run(schemes::adjustable(Rational(0)), surface, 1, control);
  const Points<S> middle = run(schemes::adjustable(Rational(1) / Rational(2)), surface, 1, control).points;
  const Points<S> end = run(schemes::adjustable(Rational(1)), surface, 1, control).points;
  Points<S> points = Points<S>::Zero(result.points.rows(), result.points.cols());
  const std::vector<S>& c = result.attributes.at(name);
  for (int i = 0; i < static_cast<int>(points.rows()); ++i) {
    const S& x = c[at(i)];
    add(points, i, S((S(1) - x) * (S(1) - S(2) * x)), result.points, i);
    add(points, i, S(S(4) * x * (S(1) - x)), middle, i);
    add(points, i, S(x * (S(2) * x - S(1))), end, i);
  }
  result.points = std::move(points);
  return result;
}

template <class S>
Surface<S> with_corners(Surface<S> surface) {
  const Mesh& mesh = *surface.mesh;
  for (int v = 0; v < mesh.vertices(); ++v) {
    if (!mesh.on_boundary(v) || mesh.valence(v) != 2) continue;
    if (surface.tags.corner.empty()) surface.tags.corner.assign(at(mesh.vertices()), 0);
    surface.tags.corner[at(v)] = 1;
  }
  return surface;
}

#define UDCP_INSTANTIATE(S)                                                                  \
  template AdjustableLimit<S> adjustable_limit<S>(const std::type_identity_t<S>&, int);      \
  template Points<S> segment_matrix<S>(const std::type_identity_t<S>&, TangentFactor);       \
  template Points<S> hybrid_patch(const Points<S>&, const std::array<S, 4>&, TangentFactor); \
  template Surface<S> hybrid_step(const Surface<S>&, const std::string&, const RunControl&); \
  template Surface<S> with_corners(Surface<S>);
UDCP_FOR_EACH_COORDINATE(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE

}  // namespace udcp
