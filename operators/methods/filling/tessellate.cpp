// A patch surface as a quad mesh.
#include "operators/interrupt.h"
#include "operators/methods/filling/patch_surface.h"

namespace udcp {
namespace {

std::size_t at(int k) { return Mesh::i(k); }

// Numbers the points of the grids so that patches share those on common edges; in the order of the faces.
class SharedGrid {
 public:
  SharedGrid(const PatchSurface& surface, int n)
      : surface_(surface), n_(n), corner_(at(surface.cage.mesh->half_edges()), -1), edge_(at(surface.cage.mesh->edges()), -1) {}

  /// Row (n + 1) j + k: the point at u = j/n, v = k/n of patch f.
  std::vector<int> of(int f) {
    const Mesh& mesh = *surface_.cage.mesh;
    std::vector<int> grid(at((n_ + 1) * (n_ + 1)), -1);
    for (int k = 0; k < 4; ++k) {
      const int h = mesh.face_begin[at(f)] + k;
      place(grid, h, 0) = once(corner_[at(fan(h))], 1);
      const int e = mesh.edge[at(h)], first = once(edge_[at(e)], n_ - 1);
      const bool forward = mesh.edge_half[at(e)] == h;
      for (int i = 1; i < n_; ++i) place(grid, h, i) = first + (forward ? i : n_ - i) - 1;
    }
    for (int& point : grid)
      if (point < 0) point = points_++;
    return grid;
  }
  [[nodiscard]] int points() const { return points_; }

 private:
  /// One half-edge for all patches that hang together around the vertex that h leaves; patches that meet there only get points of
  /// their own, as a mesh must.
  [[nodiscard]] int fan(int h) const {
    const Mesh& mesh = *surface_.cage.mesh;
    for (int g = h;;) {
      const int twin = mesh.twin[at(g)];
      if (twin < 0 || !surface_.has_patch(mesh.face[at(twin)])) return g;
      g = mesh.next(twin);
      if (g == h) return mesh.outgoing[at(mesh.vertex[at(h)])];
    }
  }
  int once(int& first, int count) {
    if (first < 0) {
      first = points_;
      points_ += count;
    }
    return first;
  }
  int& place(std::vector<int>& grid, int h, int i) const {
    const auto [u, v] = on_side(surface_, h, static_cast<double>(i) / n_);
    return grid[at((n_ + 1) * static_cast<int>(std::lround(u * n_)) + static_cast<int>(std::lround(v * n_)))];
  }

  const PatchSurface& surface_;
  int n_, points_ = 0;
  std::vector<int> corner_, edge_;
};

// What the patches say about the shared points.
class Sums {
 public:
  explicit Sums(int points)
      : result{{nullptr, Points<double>::Zero(points, 3), {}, {}}, Points<double>::Zero(points, 3)},
        seen_(at(points), 0),
        counted_(at(points), 0),
        gaussian_(at(points), 0),
        mean_(at(points), 0) {}

  void add(int i, const PatchJet& jet) {
    if (seen_[at(i)]++ == 0) result.surface.points.row(i) = jet.point.transpose();
    const SurfaceCurvature here = curvature(jet);
    if (!here.is_regular) return;
    ++counted_[at(i)];
    result.normals.row(i) += here.normal.transpose();
    gaussian_[at(i)] += here.gaussian;
    mean_[at(i)] += here.mean;
  }

  void finish() {
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      const auto row = result.normals.row(static_cast<Eigen::Index>(i));
      const double length = row.norm();
      if (length > 0) result.normals.row(static_cast<Eigen::Index>(i)) /= length;
      if (counted_[i] == 0) continue;
      gaussian_[i] /= counted_[i];
      mean_[i] /= counted_[i];
    }
    result.surface.attributes["gaussian"] = std::move(gaussian_);
    result.surface.attributes["mean"] = std::move(mean_);
  }

  Tessellation result;

 private:
  std::vector<int> seen_, counted_;
  std::vector<double> gaussian_, mean_;
};

void check_size(const PatchSurface& surface, int n, const RunControl& control) {
  if (n < 1 || n > 1000)
    throw Error(ErrorKind::input, "E_TESSELLATION",
                "a patch is cut into n x n quads with n from 1 to 1000, not " + std::to_string(n));
  std::int64_t patches = 0;
  for (int f = 0; f < surface.cage.mesh->faces(); ++f) patches += surface.has_patch(f);
  const std::int64_t faces = patches * n * n;
  if (faces > control.max_faces)
    throw Error(
        ErrorKind::limit, "E_MAX_FACES",
        "the tessellation would have " + std::to_string(faces) + " faces; the limit is " + std::to_string(control.max_faces),
        "take fewer quads per patch");
  if (patches == 0) throw Error(ErrorKind::input, "E_NO_FACES", "the surface has no patch to tessellate");
}

}  // namespace

Tessellation tessellate(const PatchSurface& surface, int n, const RunControl& control) {
  check_size(surface, n, control);
  const Mesh& mesh = *surface.cage.mesh;
  SharedGrid shared(surface, n);
  std::vector<std::vector<int>> grids(at(mesh.faces()));
  std::vector<int> begin{0}, corners;
  for (int f = 0; f < mesh.faces(); ++f) {
    if (!surface.has_patch(f)) continue;
    const std::vector<int>& grid = grids[at(f)] = shared.of(f);
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) {
        const int corner = (n + 1) * j + k;
        for (const int step : {0, n + 1, n + 2, 1}) corners.push_back(grid[at(corner + step)]);
        begin.push_back(static_cast<int>(corners.size()));
      }
    }
  }
  Sums sums(shared.points());
  for (int f = 0; f < mesh.faces(); ++f) {
    throw_if_stopped(control.stop);
    if (control.progress && f % 64 == 0) control.progress(static_cast<double>(f) / mesh.faces());
    for (int i = 0; i < static_cast<int>(grids[at(f)].size()); ++i)
      sums.add(grids[at(f)][at(i)],
               surface.patches[at(f)].at(static_cast<double>(i / (n + 1)) / n, static_cast<double>(i % (n + 1)) / n));
  }
  sums.finish();
  sums.result.surface.mesh = std::make_shared<const Mesh>(make_mesh(shared.points(), std::move(begin), std::move(corners)));
  return std::move(sums.result);
}

}  // namespace udcp
