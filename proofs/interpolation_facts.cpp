// Exact algebra of interpolation: everything comes from run() in rationals (or in formulas of lambda), tangents in Q(c)[A_n].
#include "proofs/interpolation_facts.h"

#include "operators/methods/interpolation/interpolate_points.h"
#include "operators/methods/interpolation/limit_masks.h"
#include "operators/methods/interpolation/quad_fans.h"
#include "operators/schemes.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

// cos(2 pi k/n) for k = 0 .. n - 1.
std::vector<TangentNumber> cosines(int n) {
  std::vector<TangentNumber> result;
  for (int k = 0; k < n; ++k) result.emplace_back(Algebraic::cosine(Rational(2 * k) / Rational(n)));
  return result;
}

// sin(k theta)/sin(theta) for k = 0 .. n - 1: 0, 1, 2 cos(theta), ...
std::vector<TangentNumber> sine_ratios(int n) {
  const TangentNumber twice(Algebraic(2) * Algebraic::cosine(Rational(2) / Rational(n)));
  std::vector<TangentNumber> result{TangentNumber(0), TangentNumber(1)};
  while (static_cast<int>(result.size()) < n) result.push_back(twice * result.back() - result[result.size() - 2]);
  return result;
}

// g_k = sum_j cos((j - k) theta) p_j.
std::vector<TangentNumber> transform(const std::vector<TangentNumber>& heights) {
  const int n = static_cast<int>(heights.size());
  const std::vector<TangentNumber> cosine = cosines(n);
  std::vector<TangentNumber> result(at(n));
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j) result[at(k)] += cosine[at((j - k + n) % n)] * heights[at(j)];
  return result;
}

Rational dot(const Points<Rational>& a, int i, const Points<Rational>& b, int j) {
  return a(i, 0) * b(j, 0) + a(i, 1) * b(j, 1) + a(i, 2) * b(j, 2);
}

Rational value_at(const Parametric& formula, const Rational& lambda) {
  return formula.at(std::map<std::string, Rational>{{"lambda", lambda}});
}

TangentNumber sum_of(const std::vector<TangentNumber>& values) {
  TangentNumber result;
  for (const TangentNumber& x : values) result += x;
  return result;
}

}  // namespace

Surface<Rational> first_refinement(const ExactInterpolation& what, const Points<Rational>& witness) {
  Surface<Rational> start = what.cage;
  if (what.global) {
    start.points = witness;
    return modified_step(start, what.lambda);
  }
  Surface<Rational> fine = run(schemes::catmull_clark(), start, 1);
  fine.points.topRows(witness.rows()) = witness;
  return fine;
}

// N . (P_j x P_k) = N . ((A e_j + f) x (A e_k + f')), with f = f_(j-1) + f_j and f' = f_(k-1) + f_k.
ExactRing exact_ring(const Surface<Rational>& fine, int v, const Points<Rational>& normal) {
  Fan fan;
  collect_fan(*fine.mesh, v, fan);
  const int n = fan.faces();
  const TangentNumber weight = TangentNumber::weight(n);
  Points<Rational> e(n, 3), f(n, 3);
  for (int j = 0; j < n; ++j) {
    e.row(j) = fine.points.row(fan.e[at(j)]) - fine.points.row(v);
    f.row(j) = fine.points.row(fan.f[at(j)]) + fine.points.row(fan.f[at((j + n - 1) % n)]) - Rational(2) * fine.points.row(v);
  }
  const auto triple = [&](const Points<Rational>& a, int i, const Points<Rational>& b, int j) {
    return normal(0, 0) * (a(i, 1) * b(j, 2) - a(i, 2) * b(j, 1)) + normal(0, 1) * (a(i, 2) * b(j, 0) - a(i, 0) * b(j, 2)) +
           normal(0, 2) * (a(i, 0) * b(j, 1) - a(i, 1) * b(j, 0));
  };
  ExactRing ring;
  ring.valence = n;
  for (int j = 0; j < n; ++j)
    ring.heights.push_back(weight * TangentNumber(dot(e, j, normal, 0)) + TangentNumber(dot(f, j, normal, 0)));
  const std::vector<TangentNumber> sine = sine_ratios(n);
  const TangentNumber square = weight * weight;
  for (int j = 0; j < n; ++j) {
    for (int k = j + 1; k < n; ++k) {
      const TangentNumber product = square * TangentNumber(triple(e, j, e, k)) + TangentNumber(triple(f, j, f, k)) +
                                    weight * TangentNumber(Rational(triple(e, j, f, k) + triple(f, j, e, k)));
      ring.side += sine[at(k - j)] * product;
    }
  }
  return ring;
}

// Of heights, that is of products with N/|N|^2. (6): delta^e_k = -A g_k/s, delta^f_k = -(g_k + g_(k+1))/s where s is the sum of
// the squared weights, (n/2)(A^2 + 2 (1 + c)). (5): both are -((A + 1) g_k + g_(k+1))/s with s = (n/2)((A + 1)^2 + 2 (A + 1) c +
// 1).
CorrectedRing corrected(const ExactRing& ring, bool tied) {
  const int n = ring.valence;
  const TangentNumber weight = TangentNumber::weight(n), cosine(Algebraic::cosine(Rational(2) / Rational(n)));
  const TangentNumber one(1), two(2), more = weight + one;
  const TangentNumber squares = TangentNumber(Rational(n) / Rational(2)) *
                                (tied ? more * more + two * more * cosine + one : weight * weight + two * (one + cosine));
  const TangentNumber scale = TangentNumber(-1) * squares.inverse();
  const std::vector<TangentNumber> g = transform(ring.heights);
  std::vector<TangentNumber> on_e(at(n)), on_f(at(n));
  for (int k = 0; k < n; ++k) {
    const TangentNumber& next = g[at((k + 1) % n)];
    on_e[at(k)] = scale * (tied ? more * g[at(k)] + next : weight * g[at(k)]);
    on_f[at(k)] = tied ? on_e[at(k)] : scale * (g[at(k)] + next);
  }
  CorrectedRing result{ring.heights, sum_of(on_e).is_zero() && sum_of(on_f).is_zero()};
  for (int k = 0; k < n; ++k) result.heights[at(k)] += weight * on_e[at(k)] + on_f[at(k)] + on_f[at((k + n - 1) % n)];
  return result;
}

// Of the sums with w^j, those with cos(j theta) and cos((j - 1) theta) are 0 if and only if those with cosines and sines are.
bool is_flat(const std::vector<TangentNumber>& heights) {
  const std::vector<TangentNumber> g = transform(heights);
  return g[0].is_zero() && g[1].is_zero();
}

bool are_masks_eigenvectors(int valence) {
  const RingResponse r = ring_response(schemes::catmull_clark(), valence);
  LimitMasks masks;
  const PointMask& mask = masks.inside(valence);
  for (std::size_t c = 0; c < 3; ++c) {
    Rational weight = mask.vertex * r.vertex[c];
    for (const auto& row : r.edge) weight += mask.edge * row[c];
    for (const auto& row : r.face) weight += mask.face * row[c];
    if (weight != (c == 0 ? mask.vertex : c == 1 ? mask.edge : mask.face)) return false;
  }
  // Rows that are their own mirror images: then the weights of e_0 and f_0 in the real parts decide.
  const int n = valence;
  const std::vector<TangentNumber> cosine = cosines(n);
  const TangentNumber weight = TangentNumber::weight(n), one(1);
  TangentNumber on_e, on_f;
  for (int j = 0; j < n; ++j) {
    const auto& e = r.edge[at(j)];
    const auto& f = r.face[at(j)];
    if (e[1] != r.edge[at((n - j) % n)][1] || f[2] != r.face[at((n - j) % n)][2]) return false;
    if (e[2] != r.edge[at((n + 1 - j) % n)][2] || f[1] != r.face[at(n - 1 - j)][1]) return false;
    const TangentNumber pair = cosine[at(j)] + cosine[at((j + 1) % n)];
    on_e += weight * cosine[at(j)] * TangentNumber(e[1]) + pair * TangentNumber(f[1]);
    on_f += weight * cosine[at(j)] * TangentNumber(e[2]) + pair * TangentNumber(f[2]);
  }
  const TangentNumber value = TangentNumber(Rational(1) / Rational(16)) * (TangentNumber(4) + weight);
  return (on_e - value * weight).is_zero() && (on_f - value * (one + cosine[1])).is_zero();
}

// As limit_row_inside of the running solver, in formulas: the response on quads, each f_j being a quarter of a face mean.
ExactLimitRow exact_limit_row(int valence) {
  const Mesh mesh = fan_mesh(valence, true);
  Surface<Parametric> units{std::make_shared<const Mesh>(mesh), Points<Parametric>::Zero(mesh.vertices(), 3), {}, {}};
  for (int c = 0; c < 3; ++c) units.points(c, c) = Parametric(1);  // v, e_0, f_0
  const Points<Parametric> rule = run(modified_vertex_rule_of(symbol("delta")), units, 1).points;
  const RingResponse fine = ring_response(schemes::catmull_clark(), valence);
  LimitMasks masks;
  const PointMask& mask = masks.inside(valence);
  const Parametric lambda = Parametric::variable("lambda"), delta = (Parametric(64) * lambda - Parametric(25)) / Parametric(39);
  std::array<Parametric, 3> weight;
  for (std::size_t c = 0; c < 3; ++c) {
    Rational rest;
    for (const auto& row : fine.edge) rest += mask.edge * row[c];
    for (const auto& row : fine.face) rest += mask.face * row[c];
    weight[c] = Parametric(mask.vertex) * rule(0, static_cast<Eigen::Index>(c)).substitute("delta", delta) + Parametric(rest);
  }
  return {weight[0] - Parametric(valence) * weight[2], weight[1] - Parametric(2) * weight[2], Parametric(4) * weight[2]};
}

Parametric lambda_bound(int valence) {
  return Parametric(valence) * (Parametric(20) * Parametric::variable("lambda") - Parametric(7)) / Parametric(13 * (valence + 5));
}

bool has_lambda_bound(const ExactLimitRow& row, int valence) {
  const Parametric n(valence);
  if (row.own + n * (row.edge + row.face) != Parametric(1) || row.face != Parametric(3) * row.edge) return false;
  if (row.own - n * row.edge != lambda_bound(valence)) return false;
  // own is above n edge in the range; edge is of degree 1 in lambda, so not negative if it is not at both ends
  if (!row.edge.derivative("lambda").is_constant()) return false;
  for (const Rational& end : {Rational(7) / Rational(20), Rational(1)})
    if (value_at(row.edge, end).sign() <= 0) return false;
  return true;
}

Rational checkerboard_quotient(const Mesh& mesh, const std::string& colours, const Rational& lambda) {
  require(colours.size() == at(mesh.vertices()), "there must be a colour per vertex");
  require(mesh.all_faces_have(4), "the faces must be quads");
  for (int e = 0; e < mesh.edges(); ++e) {
    const int h = mesh.edge_half[at(e)];
    require(!mesh.is_boundary_edge(e), "the mesh must be closed");
    require(colours[at(mesh.vertex[at(h)])] != colours[at(mesh.tip(h))], "an edge joins vertices of one colour");
  }
  std::map<int, std::pair<Rational, Rational>> known;  // own - n edge, both divided by edge, and 1/edge
  Rational above, below;
  for (int v = 0; v < mesh.vertices(); ++v) {
    require(colours[at(v)] == '0' || colours[at(v)] == '1', "colours must be 0 and 1");
    const int n = mesh.valence(v);
    require(n >= 3, "a vertex has two edges");
    auto found = known.find(n);
    if (found == known.end()) {
      const ExactLimitRow row = exact_limit_row(n);
      require(has_lambda_bound(row, n), "the rows are not those of the theorem");
      const Rational edge = value_at(row.edge, lambda);
      require(edge.sign() > 0, "the weight of an edge is not positive");
      found = known.emplace(n, std::pair{value_at(lambda_bound(n), lambda) / edge, Rational(1) / edge}).first;
    }
    above += found->second.first;
    below += found->second.second;
  }
  return above / below;
}

}  // namespace udcp
