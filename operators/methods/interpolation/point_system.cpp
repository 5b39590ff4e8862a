// Face means are what the convolution of U C is made of, so an n-gon enters by its mean with the same ratio to the edges at every
// valence: divided by the weight of the edges the rows are symmetric. Over a face of m corners x the terms without the diagonal
// are sum x_i x_(i+1) + (3/m) (sum x_i)^2 >= -sum x_i^2; so the eigenvalues inside are at least n(20 lambda - 7)/(13(n + 5)), as
// for quads, and along the boundary at least (32 lambda - 6)/39.
#include "operators/methods/interpolation/point_system.h"

#include <map>

#include "operators/methods/interpolation/limit_masks.h"
#include "operators/methods/interpolation/mesh_system.h"
#include "operators/schemes.h"

namespace udcp {
namespace {

std::size_t at(int k) { return Mesh::i(k); }

Rational sum(const std::vector<std::array<Rational, 3>>& rows, std::size_t column) {
  Rational result;
  for (const auto& row : rows) result += row[column];
  return result;
}

template <class S>
class LimitSystem {
 public:
  LimitSystem(const Surface<S>& cage, const PointOptions& options)
      : mesh_(*cage.mesh), targets_(cage.points), points_(cage.points), options_(options) {
    fixed_.assign(at(mesh_.vertices()), 0);
    for (int v = 0; v < mesh_.vertices(); ++v)
      fixed_[at(v)] = cage.tags.is_corner(v) || (!options.skipped.empty() && options.skipped[at(v)] != 0);
  }

  Points<S> solve() {
    solve_boundary();
    solve_inside();
    return std::move(points_);
  }

 private:
  // Numbers the unknowns of a phase; the points of all other vertices of the phase are known.
  void number_unknowns(bool on_boundary) {
    index_.assign(at(mesh_.vertices()), -1);
    unknowns_.clear();
    for (int v = 0; v < mesh_.vertices(); ++v) {
      if (fixed_[at(v)] != 0 || mesh_.on_boundary(v) != on_boundary) continue;
      index_[at(v)] = static_cast<int>(unknowns_.size());
      unknowns_.push_back(v);
    }
    system_ = {};
    right_ = Points<S>::Zero(static_cast<Eigen::Index>(unknowns_.size()), points_.cols());
  }

  void add_row(const LimitRow& row, int unknown) {
    system_.diagonal.push_back(number<S>(row.own / row.edge));
    add(right_, unknown, number<S>(Rational(1) / row.edge), targets_, unknowns_[at(unknown)]);
  }

  void add_edge(int v, int w) {
    const int i = index_[at(v)], j = index_[at(w)];
    if (i >= 0 && j >= 0)
      system_.edges.push_back({i, j});
    else if (i >= 0)
      add(right_, i, S(-1), points_, w);
    else if (j >= 0)
      add(right_, j, S(-1), points_, v);
  }

  void add_face(int f, const Rational& ratio) {
    const auto corners = mesh_.corners(f);
    const S weight = number<S>(ratio / Rational(mesh_.size(f)));
    Points<S> known = Points<S>::Zero(1, points_.cols());
    std::size_t members = 0;
    for (const int v : corners) {
      if (index_[at(v)] < 0) {
        add(known, 0, weight, points_, v);
      } else {
        system_.member.push_back(index_[at(v)]);
        ++members;
      }
    }
    if (members == 0) return;
    for (std::size_t k = system_.member.size() - members; k < system_.member.size(); ++k)
      add(right_, system_.member[k], S(-1), known, 0);
    system_.face_begin.push_back(static_cast<int>(system_.member.size()));
    system_.face_weight.push_back(weight);
  }

  void finish() {
    const Points<S> found = udcp::solve(system_, right_, options_.control);
    for (std::size_t k = 0; k < unknowns_.size(); ++k) points_.row(unknowns_[k]) = found.row(static_cast<Eigen::Index>(k));
  }

  void solve_boundary() {
    number_unknowns(true);
    if (unknowns_.empty()) return;
    const LimitRow row = limit_row_on_boundary(options_.lambda);
    for (std::size_t k = 0; k < unknowns_.size(); ++k) add_row(row, static_cast<int>(k));
    for (int e = 0; e < mesh_.edges(); ++e) {
      const int h = mesh_.edge_half[at(e)];
      if (mesh_.is_boundary_edge(e)) add_edge(mesh_.vertex[at(h)], mesh_.tip(h));
    }
    finish();
  }

  void solve_inside() {
    number_unknowns(false);
    std::map<int, LimitRow> rows;
    Rational ratio;
    for (std::size_t k = 0; k < unknowns_.size(); ++k) {
      const int n = mesh_.valence(unknowns_[k]);
      auto known = rows.find(n);
      if (known == rows.end()) known = rows.emplace(n, limit_row_inside(options_.lambda, n)).first;
      const LimitRow& row = known->second;
      if (k == 0) ratio = row.face / row.edge;
      if (row.face / row.edge != ratio) throw Error(ErrorKind::internal, "E_INTERNAL", "the limit rows are not symmetric", "");
      add_row(row, static_cast<int>(k));
    }
    for (int e = 0; e < mesh_.edges(); ++e) {
      const int h = mesh_.edge_half[at(e)];
      add_edge(mesh_.vertex[at(h)], mesh_.tip(h));
    }
    for (int f = 0; f < mesh_.faces(); ++f) add_face(f, ratio);
    finish();
  }

  const Mesh& mesh_;
  const Points<S>& targets_;
  Points<S> points_;
  const PointOptions& options_;
  std::vector<char> fixed_;
  std::vector<int> index_, unknowns_;
  MeshSystem<S> system_;
  Points<S> right_;
};

}  // namespace

// The response on quads, with the weights of f_j turned into those of face means: each is a quarter of one.
LimitRow limit_row_inside(const Rational& lambda, int valence) {
  LimitMasks masks;
  const PointMask& mask = masks.inside(valence);
  const RingResponse fine = ring_response(schemes::catmull_clark(), valence);
  const RingResponse rule = ring_response(modified_vertex_rule(lambda), valence);
  std::array<Rational, 3> weight;
  for (std::size_t c = 0; c < 3; ++c)
    weight[c] = mask.vertex * rule.vertex[c] + mask.edge * sum(fine.edge, c) + mask.face * sum(fine.face, c);
  return {weight[0] - Rational(valence) * weight[2], weight[1] - Rational(2) * weight[2], Rational(4) * weight[2]};
}

LimitRow limit_row_on_boundary(const Rational& lambda) {
  LimitMasks masks;
  const PointMask& mask = masks.boundary();
  const BoundaryResponse fine = boundary_response(schemes::catmull_clark());
  const BoundaryResponse rule = boundary_response(modified_vertex_rule(lambda));
  return {mask.vertex * rule.vertex[0] + Rational(2) * mask.edge * fine.end[0],
          mask.vertex * rule.vertex[1] + mask.edge * fine.end[1], Rational(0)};
}

template <class S>
Points<S> solve_for_limits(const Surface<S>& cage, const PointOptions& options) {
  return LimitSystem<S>(cage, options).solve();
}

#define UDCP_INSTANTIATE(S) template Points<S> solve_for_limits(const Surface<S>&, const PointOptions&);
UDCP_FOR_EACH_COORDINATE(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE

}  // namespace udcp
