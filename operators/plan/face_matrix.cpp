// Kinds forward, matrices backward.
#include "operators/plan/face_matrix.h"

#include <array>
#include <map>

#include "operators/interrupt.h"
#include "operators/limit.h"
#include "operators/neighbourhood.h"
#include "operators/plan/block.h"
#include "operators/run.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

// A face after one round: where it lies in its parent, and what it looks like.
struct Child {
  int kind = 0, turn = 0;  // and the corner at (0, 0), (1, 0), .. from which its kind is seen
  int i = 0, j = 0;
  bool points_down = false;  // a triangle whose corner 0 is at (i + 1, j + 1)
  std::vector<int> vertex;   // of its neighbourhood, in the refined sheet
};

template <int N>
struct Level {
  FaceKinds<N> kinds;
  std::vector<int> first_vertex;  // of each kind in the sheet
  Points<double> fine;            // the refined sheet: a row per point, columns as in each kind
  std::vector<Child> children;    // arity^2 per kind
};

// Half-edges from which the grid of a refined face is walked: the one at the bottom of each child.
template <int N>
class GridWalk {
 public:
  GridWalk(const Mesh& mesh, int arity) : mesh_(mesh), arity_(arity) {}

  /// visit(half, i, j, points_down) for the children of face `face` of the mesh before.
  template <class Visit>
  void children(int face, Visit visit) const {
    int row = N * arity_ * arity_ * face;
    for (int j = 0; j < arity_; ++j) {
      const int last = N == 4 ? arity_ - 1 : arity_ - 1 - j;
      int h = row;
      for (int i = 0; i <= last; ++i) {
        visit(h, i, j, false);
        if (i == last) break;
        if constexpr (N == 3) visit(down(h), i, j, true);
        h = right(h);
      }
      if (j + 1 < arity_) row = above(row);
    }
  }

 private:
  [[nodiscard]] int across(int h) const { return mesh_.twin[at(h)]; }
  // The triangle beside one that points up; its half-edge at the top, from right to left.
  [[nodiscard]] int down(int h) const { return mesh_.next(mesh_.next(across(mesh_.next(h)))); }
  [[nodiscard]] int right(int h) const {
    return N == 4 ? mesh_.next(across(mesh_.next(h))) : mesh_.next(across(mesh_.prev(down(h))));
  }
  [[nodiscard]] int above(int h) const { return N == 4 ? across(mesh_.next(mesh_.next(h))) : across(down(h)); }

  const Mesh& mesh_;
  int arity_;
};

template <int N>
class Matrices {
 public:
  Matrices(const RoundsAhead& ahead, BlockContent content, const std::atomic<bool>* stop)
      : ahead_(ahead), content_(content), stop_(stop) {}

  std::vector<Points<double>> of(const FaceKinds<N>& kinds) {
    levels_.push_back({kinds, {}, {}, {}});
    for (int round = 0; round < ahead_.rounds; ++round) refine(round);
    std::vector<Points<double>> matrices = at_corners();
    for (int round = ahead_.rounds - 1, segments = 1; round >= 0; --round, segments *= ahead_.arity)
      matrices = put_together(levels_[at(round)], matrices, segments);
    return matrices;
  }

 private:
  using Sheet = typename FaceKinds<N>::Sheet;

  // Unit vectors on every kind of the sheet, the same columns for all of them: they do not touch.
  Surface<double> with_unit_vectors(const FaceKinds<N>& kinds, Sheet& sheet) const {
    Surface<double> surface;
    surface.points = Points<double>::Zero(sheet.first_vertex.back(), kinds.most_vertices());
    for (int k = 0; k < kinds.size(); ++k)
      for (int v = 0; v < kinds[k].vertices; ++v) surface.points(sheet.first_vertex[at(k)] + v, v) = 1;
    surface.mesh = std::make_shared<const Mesh>(std::move(sheet.mesh));
    surface.tags = std::move(sheet.tags);
    return surface;
  }

  // One round on all kinds of a level, and the kinds of the faces that it makes.
  void refine(int round) {
    Level<N>& level = levels_[at(round)];
    Sheet sheet = level.kinds.sheet();
    RunControl control;
    control.first_item = ahead_.item_of(round);
    control.stop = stop_;
    Surface<double> fine = run(ahead_.word, with_unit_vectors(level.kinds, sheet), 1, control);
    level.fine = std::move(fine.points);
    const int rings = ahead_.rings[at(round) + 1];
    Level<N> next;
    const Starts<N> starts(*fine.mesh, fine.tags, rings);
    RingWalker<N> walker(*fine.mesh, fine.tags, rings);
    const GridWalk<N> grid(*fine.mesh, ahead_.arity);
    for (int kind = 0; kind < level.kinds.size(); ++kind) {
      grid.children(sheet.first_face[at(kind)], [&](int half, int i, int j, bool points_down) {
        const int start = starts.of_face(half / N);
        const FaceRings& around = walker.around(start);
        const int child = next.kinds.add(around, walker, fine.tags, *fine.mesh);
        level.children.push_back({child, (start - half + N) % N, i, j, points_down, around.vertex});
      });
    }
    levels_.push_back(std::move(next));
  }

  // After the last round: a block is the corners of its face, which are the first vertices of the neighbourhood.
  std::vector<Points<double>> at_corners() const {
    const FaceKinds<N>& kinds = levels_.back().kinds;
    if (content_.limit_points || content_.tangents) return limits_at_corners(kinds);
    std::vector<Points<double>> matrices;
    for (int k = 0; k < kinds.size(); ++k) matrices.push_back(Points<double>::Identity(N, kinds[k].vertices));
    return matrices;
  }

  std::vector<Points<double>> limits_at_corners(const FaceKinds<N>& kinds) const {
    const Sheet sheet = kinds.sheet();
    RunControl control;
    control.first_item = ahead_.item_of(ahead_.rounds);
    control.stop = stop_;
    std::map<std::vector<int>, LimitStencil> known;
    std::vector<Points<double>> matrices;
    for (int k = 0; k < kinds.size(); ++k) {
      Points<double> matrix = Points<double>::Zero((content_.tangents ? 3 : 1) * N, kinds[k].vertices);
      for (int corner = 0; corner < N; ++corner) {
        const int half = N * sheet.first_face[at(k)] + corner, v = sheet.mesh.vertex[at(half)];
        const int start = sheet.mesh.on_boundary(v) ? sheet.mesh.outgoing[at(v)] : half;
        const Neighbourhood local = neighbourhood(sheet.mesh, sheet.tags, start, limit_rings(ahead_.word));
        auto found = known.find(local.signature);
        if (found == known.end()) found = known.emplace(local.signature, limit_stencil(ahead_.word, local, control)).first;
        place_stencil(found->second, local, sheet.first_vertex[at(k)], corner, matrix);
      }
      matrices.push_back(std::move(matrix));
    }
    return matrices;
  }

  void place_stencil(const LimitStencil& stencil, const Neighbourhood& local, int first, int corner,
                     Points<double>& matrix) const {
    const auto spread = [&](int row, const Eigen::RowVectorXd& weights) {
      for (std::size_t k = 0; k < local.vertex.size(); ++k)
        matrix(row, local.vertex[k] - first) += weights[static_cast<Eigen::Index>(k)];
    };
    if (content_.limit_points) {
      spread(corner, stencil.point);
    } else {
      matrix(corner, corner) = 1;
    }
    if (!content_.tangents) return;
    spread(N + corner, stencil.tangent[0]);
    spread(2 * N + corner, stencil.tangent[1]);
  }

  // Blocks with `segments` segments per edge become those of their parents.
  std::vector<Points<double>> put_together(const Level<N>& level, const std::vector<Points<double>>& blocks, int segments) const {
    const Block<N> small{segments}, large{segments * ahead_.arity};
    const int layers = content_.tangents ? 3 : 1;
    const std::size_t per_kind = at(ahead_.arity) * at(ahead_.arity);
    std::vector<Points<double>> matrices;
    for (int k = 0; k < level.kinds.size(); ++k) {
      throw_if_stopped(stop_);
      const int columns = level.kinds[k].vertices;
      Points<double> matrix(layers * large.points(), columns), step;
      for (std::size_t c = 0; c < per_kind; ++c) {
        const Child& child = level.children[per_kind * at(k) + c];
        step.resize(static_cast<Eigen::Index>(child.vertex.size()), columns);
        for (std::size_t r = 0; r < child.vertex.size(); ++r)
          step.row(static_cast<Eigen::Index>(r)) = level.fine.row(child.vertex[r]).head(columns);
        const Points<double> rows = blocks[at(child.kind)] * step;
        small.for_each_place([&](Place p) {
          const int from = small.row(p), to = large.row(in_parent(child, small, p));
          for (int layer = 0; layer < layers; ++layer)
            matrix.row(layer * large.points() + to) = rows.row(layer * small.points() + from);
        });
      }
      matrices.push_back(std::move(matrix));
    }
    return matrices;
  }

  static Place in_parent(const Child& child, const Block<N>& block, Place p) {
    const Place q = block.turned(p, child.turn);
    if (child.points_down) return {block.n * (child.i + 1) - q.i, block.n * (child.j + 1) - q.j};
    return {block.n * child.i + q.i, block.n * child.j + q.j};
  }

  const RoundsAhead& ahead_;
  BlockContent content_;
  const std::atomic<bool>* stop_;
  std::vector<Level<N>> levels_;
};

}  // namespace

template <int N>
std::vector<Points<double>> face_matrices(const FaceKinds<N>& kinds, const RoundsAhead& ahead, BlockContent content,
                                          const std::atomic<bool>* stop) {
  return Matrices<N>(ahead, content, stop).of(kinds);
}

#define UDCP_INSTANTIATE(N)                                                                                 \
  template std::vector<Points<double>> face_matrices(const FaceKinds<N>&, const RoundsAhead&, BlockContent, \
                                                     const std::atomic<bool>*);
UDCP_INSTANTIATE(3)
UDCP_INSTANTIATE(4)
#undef UDCP_INSTANTIATE

}  // namespace udcp
