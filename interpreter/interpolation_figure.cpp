// Meshes side by side, and spikes for normals: as one mesh, so that every writer can take it.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "interpreter/interpolation.h"
#include "operators/schemes.h"

namespace udcp {
namespace {

// To the right in the usual view, where the eye is at (1, -1.6, 0.9).
const Eigen::RowVector3d sideways = Eigen::RowVector3d(1.6, 1, 0).normalized();

struct Part {
  Surface<double> surface;
  double place = 0;  // how far sideways it is moved
  double number = 0;
};

Surface<double> joined(const std::vector<Part>& parts) {
  std::vector<int> begin{0}, corners;
  Eigen::Index rows = 0;
  for (const Part& part : parts) rows += part.surface.points.rows();
  Surface<double> result;
  result.points.resize(rows, 3);
  std::vector<double>& number = result.attributes["part"];
  rows = 0;
  for (const Part& part : parts) {
    const Mesh& mesh = *part.surface.mesh;
    for (int f = 0; f < mesh.faces(); ++f) {
      for (const int v : mesh.corners(f)) corners.push_back(v + static_cast<int>(rows));
      begin.push_back(static_cast<int>(corners.size()));
    }
    result.points.middleRows(rows, mesh.vertices()) = part.surface.points;
    result.points.middleRows(rows, mesh.vertices()).rowwise() += part.place * sideways;
    number.insert(number.end(), Mesh::i(mesh.vertices()), part.number);
    rows += mesh.vertices();
  }
  result.mesh = std::make_shared<const Mesh>(make_mesh(static_cast<int>(rows), std::move(begin), std::move(corners)));
  return result;
}

double width_of(const Surface<double>& surface) {
  const Eigen::VectorXd along = surface.points * sideways.transpose();
  return along.maxCoeff() - along.minCoeff();
}

// Shorter than most edges, and than a tenth of the mesh.
double usual_length(const Surface<double>& cage) {
  double sum = 0;
  for (const int h : cage.mesh->edge_half)
    sum += (cage.points.row(cage.mesh->vertex[Mesh::i(h)]) - cage.points.row(cage.mesh->tip(h))).norm();
  const double size = (cage.points.colwise().maxCoeff() - cage.points.colwise().minCoeff()).norm();
  return std::min(0.1 * size, 0.6 * sum / cage.mesh->edges());
}

}  // namespace

Surface<double> spikes(const Points<double>& points, const Points<double>& normals, double length) {
  const Eigen::Index count = points.rows();
  Surface<double> result;
  result.points.resize(4 * count, 3);
  std::vector<int> begin{0}, corners;
  for (Eigen::Index v = 0; v < count; ++v) {
    const Eigen::Vector3d n = normals.row(v).transpose().stableNormalized(), p = points.row(v);
    const Eigen::Vector3d side = n.unitOrthogonal(), other = n.cross(side);
    for (int k = 0; k < 3; ++k) {
      const double angle = 2 * std::acos(-1.0) * k / 3;
      result.points.row(4 * v + k) = (p + length / 16 * (std::cos(angle) * side + std::sin(angle) * other)).transpose();
    }
    result.points.row(4 * v + 3) = (p + length * n).transpose();
    const int base = static_cast<int>(4 * v);
    for (const auto& face : {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{1, 2, 3}, std::array{2, 0, 3}}) {
      for (const int k : face) corners.push_back(base + k);
      begin.push_back(static_cast<int>(corners.size()));
    }
  }
  result.mesh = std::make_shared<const Mesh>(make_mesh(static_cast<int>(4 * count), std::move(begin), std::move(corners)));
  return result;
}

Surface<double> interpolation_figure(const InterpolationRun& run, int rounds, double length, const RunControl& control) {
  const Word& word = schemes::catmull_clark();
  const Surface<double> cage{run.cage.mesh, run.cage.points, run.cage.tags, {}};
  Surface<double> control_mesh = run.result.control;
  control_mesh.attributes.clear();
  const int more = std::max(0, rounds - run.result.rounds);
  const Surface<double> plain = udcp::run(word, cage, run.result.rounds + more, control);
  const Surface<double> through = udcp::run(word, control_mesh, more, control);
  const double size = (cage.points.colwise().maxCoeff() - cage.points.colwise().minCoeff()).norm();
  const double gap = 0.15 * size, first = 0.5 * (width_of(cage) + width_of(plain)) + gap,
               second = first + 0.5 * (width_of(plain) + width_of(through)) + gap;
  std::vector<Part> parts{{cage, 0, 0}, {plain, first, 1}, {through, second, 2}};
  std::vector<int> with;
  for (int v = 0; v < static_cast<int>(run.normals.rows()); ++v)
    if (run.options.skipped_normals.empty() || run.options.skipped_normals[Mesh::i(v)] == 0) with.push_back(v);
  if (!with.empty()) {
    Points<double> points(static_cast<Eigen::Index>(with.size()), 3), normals = points;
    for (std::size_t k = 0; k < with.size(); ++k) {
      points.row(static_cast<Eigen::Index>(k)) = cage.points.row(with[k]);
      normals.row(static_cast<Eigen::Index>(k)) = run.normals.row(with[k]);
    }
    parts.push_back({spikes(points, normals, length > 0 ? length : usual_length(cage)), second, 3});
  }
  return joined(parts);
}

}  // namespace udcp
