// Three unit vectors are enough per valence, as the ring of quads is its own image under a turn. The frequency 0 of the response
// gives the limit point exactly, frequency 1 (a real matrix of two rows) the tangents.
#include "operators/methods/interpolation/limit_masks.h"

#include <cmath>

#include "operators/methods/interpolation/quad_fans.h"
#include "operators/run.h"
#include "operators/schemes.h"

namespace udcp {
namespace {

std::size_t at(int k) { return Mesh::i(k); }

// Columns: one for v, one for each further vertex of `unit`.
Points<Rational> run_units(const Word& word, const Mesh& mesh, const std::vector<int>& unit) {
  Surface<Rational> surface{std::make_shared<const Mesh>(mesh), Points<Rational>::Zero(mesh.vertices(), 3), {}, {}};
  for (std::size_t c = 0; c < unit.size(); ++c) surface.points(unit[c], static_cast<Eigen::Index>(c)) = Rational(1);
  return run(word, std::move(surface), 1).points;
}

std::array<Rational, 3> row_of(const Points<Rational>& points, int i) { return {points(i, 0), points(i, 1), points(i, 2)}; }

Rational sum(const std::vector<std::array<Rational, 3>>& rows, std::size_t column) {
  Rational result;
  for (const auto& row : rows) result += row[column];
  return result;
}

// The sum over j of row j's weight times cos((j + shift) theta), theta = 2 pi/n.
double frequency_one(const std::vector<std::array<Rational, 3>>& rows, std::size_t column, const Rational& shift) {
  const Rational n(static_cast<int>(rows.size()));
  double result = 0;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    const Rational& weight = rows[j][column];
    if (!weight.is_zero())
      result += weight.to_double() * cosine<double>(Rational(2) * (Rational(static_cast<int>(j)) + shift) / n);
  }
  return result;
}

}  // namespace

RingResponse ring_response(const Word& word, int valence) {
  const Mesh mesh = fan_mesh(valence, true);
  Fan fan;
  collect_fan(mesh, 0, fan);
  const Points<Rational> points = run_units(word, mesh, {0, fan.e[0], fan.f[0]});
  RingResponse result;
  result.vertex = row_of(points, 0);
  for (int h = mesh.outgoing[0], j = 0; j < valence; ++j, h = mesh.around(h)) {
    result.edge.push_back(row_of(points, mesh.vertices() + mesh.edge[at(h)]));
    result.face.push_back(row_of(points, mesh.vertices() + mesh.edges() + mesh.face[at(h)]));
  }
  return result;
}

BoundaryResponse boundary_response(const Word& word) {
  const Mesh mesh = fan_mesh(2, false);
  const Points<Rational> points = run_units(word, mesh, {0, 1});
  const int end = mesh.vertices() + mesh.edge[at(mesh.outgoing[0])];
  return {{points(0, 0), points(0, 1)}, {points(end, 0), points(end, 1)}};
}

const RingResponse& LimitMasks::response(int valence) {
  const auto found = responses_.find(valence);
  if (found != responses_.end()) return found->second;
  return responses_.emplace(valence, ring_response(schemes::catmull_clark(), valence)).first->second;
}

// x = x B for the weights x = (1, edge, face) of v, each e, each f, and the sums B of the response.
const PointMask& LimitMasks::inside(int valence) {
  const auto found = inside_.find(valence);
  if (found != inside_.end()) return found->second;
  const RingResponse& r = response(valence);
  const Rational ee = Rational(1) - sum(r.edge, 1), fe = sum(r.face, 1), ef = sum(r.edge, 2), ff = Rational(1) - sum(r.face, 2);
  const Rational determinant = ee * ff - fe * ef;
  PointMask mask{Rational(1), (r.vertex[1] * ff + r.vertex[2] * fe) / determinant,
                 (r.vertex[2] * ee + r.vertex[1] * ef) / determinant};
  const Rational total = Rational(1) + Rational(valence) * (mask.edge + mask.face);
  mask = {mask.vertex / total, mask.edge / total, mask.face / total};
  return inside_.emplace(valence, mask).first->second;
}

const PointMask& LimitMasks::boundary() {
  if (boundary_.empty()) {
    const BoundaryResponse r = boundary_response(schemes::catmull_clark());
    const Rational edge = r.vertex[1] / (Rational(1) - r.end[1]), total = Rational(1) + Rational(2) * edge;
    boundary_.push_back({Rational(1) / total, edge / total, Rational(0)});
  }
  return boundary_.front();
}

// With the phases j theta on e and (j + 1/2) theta on f the matrix of frequency 1 is real: (edge, face) B = eigenvalue (edge,
// face).
const TangentMask& LimitMasks::tangents(int valence) {
  const auto found = tangents_.find(valence);
  if (found != tangents_.end()) return found->second;
  const RingResponse& r = response(valence);
  const Rational half = Rational(1) / Rational(2);
  const double ee = frequency_one(r.edge, 1, Rational(0)), ef = frequency_one(r.edge, 2, -half);
  const double fe = frequency_one(r.face, 1, half), ff = frequency_one(r.face, 2, Rational(0));
  TangentMask mask;
  mask.eigenvalue = (ee + ff) / 2 + std::sqrt((ee - ff) * (ee - ff) / 4 + ef * fe);
  mask.face = 2 * cosine<double>(Rational(1) / Rational(valence));
  mask.edge = mask.face * (mask.eigenvalue - ff) / ef;
  return tangents_.emplace(valence, mask).first->second;
}

// The modes that vanish on the boundary are those of valence 2k inside with sines: e_0 and e_k are where the sine is 0. What the
// new e_j and f_j take from v and from the ends is then balanced by weights on v and the ends.
const AcrossMask& LimitMasks::across(int faces) {
  const auto found = across_.find(faces);
  if (found != across_.end()) return found->second;
  AcrossMask mask{tangents(2 * faces)};
  const Mesh mesh = fan_mesh(faces, false);
  const Points<Rational> points = run_units(schemes::catmull_clark(), mesh, {0, 1});
  const auto sine = [&](const Rational& j) { return cosine<double>(Rational(1) / Rational(2) - j / Rational(faces)); };
  double from_vertex = 0, from_end = 0;
  for (int h = mesh.outgoing[0], j = 0; j < faces; ++j, h = mesh.around(h)) {
    const int e = mesh.vertices() + mesh.edge[at(h)], f = mesh.vertices() + mesh.edges() + mesh.face[at(h)];
    const double on_e = mask.inside.edge * sine(Rational(j));
    const double on_f = mask.inside.face * sine(Rational(j) + Rational(1) / Rational(2));
    from_vertex += (j > 0 ? on_e * points(e, 0).to_double() : 0) + on_f * points(f, 0).to_double();
    from_end += (j > 0 ? on_e * points(e, 1).to_double() : 0) + on_f * points(f, 1).to_double();
  }
  const BoundaryResponse r = boundary_response(schemes::catmull_clark());
  const double vv = mask.inside.eigenvalue - r.vertex[0].to_double(), va = r.vertex[1].to_double();
  const double av = r.end[0].to_double(), aa = mask.inside.eigenvalue - r.end[1].to_double();
  const double determinant = vv * aa - 2 * va * av;
  mask.vertex = (from_vertex * aa + 2 * av * from_end) / determinant;
  mask.end = (vv * from_end + va * from_vertex) / determinant;
  return across_.emplace(faces, mask).first->second;
}

}  // namespace udcp
