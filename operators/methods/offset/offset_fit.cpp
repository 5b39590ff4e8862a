// Sparse normal equations, assembled face by face.
#include "operators/methods/offset/offset_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "operators/interrupt.h"
#include "operators/methods/offset/loop_limit.h"
#include "operators/methods/sparse_solvers.h"
#include "operators/schemes.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

constexpr int rounds = 2;
constexpr double most_weights = 2e8;

using Vector = Eigen::RowVector3d;

/// The vertices that points of each face depend on: the one-rings of its corners.
std::vector<std::vector<int>> face_supports(const Mesh& mesh) {
  const VertexRings rings(mesh);
  std::vector<std::vector<int>> supports(at(mesh.faces()));
  for (int f = 0; f < mesh.faces(); ++f) {
    std::vector<int>& support = supports[at(f)];
    for (const int v : mesh.corners(f)) {
      support.push_back(v);
      support.insert(support.end(), rings.of(v).begin(), rings.of(v).end());
    }
    std::ranges::sort(support);
    support.erase(std::unique(support.begin(), support.end()), support.end());
  }
  return supports;
}

/// Colours such that no two vertices of one support share one: greedily, in the order of the vertices.
std::vector<int> colours_of(const Mesh& mesh, const std::vector<std::vector<int>>& supports, int& count) {
  std::vector<std::vector<int>> faces_of(at(mesh.vertices()));
  for (std::size_t f = 0; f < supports.size(); ++f)
    for (const int v : supports[f]) faces_of[at(v)].push_back(static_cast<int>(f));
  std::vector<int> colour(at(mesh.vertices()), -1), used;
  count = 0;
  for (int v = 0; v < mesh.vertices(); ++v) {
    used.assign(at(count) + 1, 0);
    for (const int f : faces_of[at(v)])
      for (const int u : supports[at(f)])
        if (colour[at(u)] >= 0) used[at(colour[at(u)])] = 1;
    const int free = static_cast<int>(std::ranges::find(used, 0) - used.begin());
    colour[at(v)] = free;
    count = std::max(count, free + 1);
  }
  return colour;
}

/// Limits at the vertices of the refined mesh: of S, its normal, and of the unit vectors, all of one colour in a column.
struct Samples {
  std::shared_ptr<const Mesh> mesh;
  Points<double> normal, weights;
  std::vector<double> area;
};

Samples samples_of(const Surface<double>& surface, const std::vector<int>& colour, int colours, const RunControl& control) {
  const double entries = 16.0 * surface.mesh->vertices() * (3.0 + colours);
  if (entries > most_weights)
    throw Error(ErrorKind::limit, "E_TOO_LARGE",
                "a fit on " + std::to_string(surface.mesh->vertices()) + " vertices needs " +
                    std::to_string(static_cast<long long>(entries)) + " weights; the limit is 200000000",
                "leave out fit = yes");
  Surface<double> field{surface.mesh, Points<double>::Zero(surface.points.rows(), 3 + colours), surface.tags, {}};
  field.points.leftCols(3) = surface.points;
  for (std::size_t v = 0; v < colour.size(); ++v) field.points(static_cast<Eigen::Index>(v), 3 + colour[v]) = 1;
  const Surface<double> fine = run(schemes::loop(), std::move(field), rounds, control);
  const LoopLimit<double> limit(fine.mesh, fine.tags);
  const Points<double> all = limit.points(fine.points), position = all.leftCols(3);
  Samples samples{fine.mesh, limit_normals<double>(limit, fine.points.leftCols(3)), all.rightCols(colours),
                  std::vector<double>(at(fine.mesh->vertices()), 0.0)};
  double total = 0;
  for (int f = 0; f < fine.mesh->faces(); ++f) {
    const auto c = fine.mesh->corners(f);
    const Vector a = position.row(c[1]) - position.row(c[0]), b = position.row(c[2]) - position.row(c[0]);
    const double third = a.cross(b).norm() / 6;
    for (const int v : c) samples.area[at(v)] += third;
    total += 3 * third;
  }
  for (double& area : samples.area) area *= static_cast<double>(samples.area.size()) / total;
  return samples;
}

class Equations {
 public:
  Equations(const Samples& samples, const std::vector<int>& colour, double distance, double alpha, int vertices)
      : samples_(samples),
        colour_(colour),
        distance_(distance),
        alpha_(alpha),
        right_(Points<double>::Zero(3 * vertices, 1)),
        done_(samples.area.size(), 0) {}

  /// Adds the samples of one face that no face before had.
  void add_face(int face, const std::vector<int>& support) {
    const auto n = static_cast<Eigen::Index>(support.size());
    Eigen::MatrixXd local = Eigen::MatrixXd::Zero(3 * n, 3 * n);
    const int children = 1 << (2 * rounds);
    Eigen::VectorXd weight(n);
    for (int h = 3 * children * face; h < 3 * children * (face + 1); ++h) {
      const int s = samples_.mesh->vertex[at(h)];
      if (done_[at(s)] != 0) continue;
      done_[at(s)] = 1;
      for (Eigen::Index k = 0; k < n; ++k) weight[k] = samples_.weights(s, colour_[at(support[static_cast<std::size_t>(k)])]);
      const Eigen::Vector3d normal = samples_.normal.row(s).transpose();
      const Eigen::Matrix3d block =
          samples_.area[at(s)] * (alpha_ * Eigen::Matrix3d::Identity() + (1 - alpha_) * normal * normal.transpose());
      for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j <= i; ++j) local.block<3, 3>(3 * i, 3 * j) += weight[i] * weight[j] * block;
        right_.block<3, 1>(3 * support[static_cast<std::size_t>(i)], 0) += samples_.area[at(s)] * weight[i] * distance_ * normal;
      }
    }
    hand_on(local, support);
  }

  Points<double> solve(int vertices) const {
    const Points<double> x = solve_positive_definite(3 * vertices, entries_, right_);
    return Eigen::Map<const Points<double>>(x.data(), vertices, 3);
  }

 private:
  // Supports are sorted, so a row of the local matrix is a lower row of the global one.
  void hand_on(const Eigen::MatrixXd& local, const std::vector<int>& support) {
    for (std::size_t i = 0; i < support.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        for (int a = 0; a < 3; ++a) {
          for (int b = 0; b < (i == j ? a + 1 : 3); ++b) {
            const double value = local(static_cast<Eigen::Index>(3 * i) + a, static_cast<Eigen::Index>(3 * j) + b);
            if (value != 0) entries_.push_back({3 * support[i] + a, 3 * support[j] + b, value});
          }
        }
      }
    }
  }

  const Samples& samples_;
  const std::vector<int>& colour_;
  double distance_, alpha_;
  Points<double> right_;
  std::vector<char> done_;
  std::vector<Entry> entries_;
};

}  // namespace

Points<double> fit_offset(const Surface<double>& surface, double distance, double alpha, const RunControl& control) {
  if (!(alpha > 0))
    throw Error(ErrorKind::input, "E_FIT_WEIGHT", "the weight of slip in a fit must be positive, not " + to_text(alpha), "");
  const Mesh& mesh = *surface.mesh;
  const std::vector<std::vector<int>> supports = face_supports(mesh);
  int colours = 0;
  const std::vector<int> colour = colours_of(mesh, supports, colours);
  const Samples samples = samples_of(surface, colour, colours, control);
  Equations equations(samples, colour, distance, alpha, mesh.vertices());
  for (int f = 0; f < mesh.faces(); ++f) {
    throw_if_stopped(control.stop);
    equations.add_face(f, supports[at(f)]);
  }
  return equations.solve(mesh.vertices());
}

}  // namespace udcp
