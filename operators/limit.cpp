// Limits as stencils: neighbourhoods go through run() on unit vectors until they repeat; then the repeating matrix is taken
// apart.
#include "operators/limit.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "operators/interrupt.h"
#include "operators/matrix.h"
#include "operators/modes.h"

namespace udcp {
namespace {

using Matrix = Eigen::MatrixXd;
using Row = Eigen::RowVectorXd;

std::size_t at(int k) { return Mesh::i(k); }

constexpr int settling_rounds = 12;  // irregular faces and vertices leave a neighbourhood after a few rounds
constexpr int drifting_rounds = 52;  // alpha has then lost the bits of a double

bool is_stationary(const Word& word) {
  for (const Item& item : word.tail) {
    for (const KernelPtr& kernel : {item.f.plain, item.f.latitude, item.f.longitude, item.omega.plain, item.omega.latitude,
                                    item.omega.longitude, item.omega_face, item.delta})
      if (kernel && kernel->needs().round) return false;
  }
  return word.rings == Rings::off;
}

void require_limit(const Word& word) {
  if (!word.is_scheme())
    throw Error(ErrorKind::word, "E_NO_SCHEME", "a finite operator has no limit", "repeat it for ever: (...)*");
  int averages = 0;
  const auto needs_vertex = [](const KernelPtr& kernel) { return kernel && kernel->needs().vertex; };
  for (const std::vector<Item>* items : {&word.head, &word.tail}) {
    for (const Item& item : *items) {
      if (item.atom == Atom::average) ++averages;
      if (item.atom == Atom::up && averages % 2 != 0) break;
      for (const KernelPtr& kernel : {item.f.plain, item.f.latitude, item.f.longitude, item.omega.plain, item.omega.latitude,
                                      item.omega.longitude, item.omega_face, item.delta})
        if (needs_vertex(kernel))
          throw Error(ErrorKind::word, "E_LIMIT_VARIES",
                      "parameters that differ from point to point (v.name, noise) have no limit stencils",
                      "refine a few rounds instead: mesh |> word^6");
    }
    if (averages % 2 != 0)
      throw Error(ErrorKind::word, "E_LIMIT_DUAL",
                  "the word has an odd number of D, so its new points do not correspond to the old ones",
                  "refine a few rounds instead: mesh |> word^6");
  }
  for (const KernelPtr& kernel : {word.alpha0.plain, word.alpha0.latitude, word.alpha0.longitude}) {
    if (kernel && (kernel->needs().vertex || kernel->needs().valence))
      throw Error(ErrorKind::word, "E_LIMIT_VARIES", "an alpha0 that differs from point to point has no limit stencils",
                  "refine a few rounds instead: mesh |> word^6");
  }
}

// The round at which the limit starts: after what counts as applied, and after the head in any case.
int first_tail_item(const Word& word, const RunControl& control) {
  return control.first_item > 0 ? control.first_item : static_cast<int>(word.head.size());
}

RunControl from_item(int item, const RunControl& control) {
  RunControl result;
  result.first_item = item;
  result.stop = control.stop;
  return result;
}

// The left eigenvector of the eigenvalue 1, entries summing to 1: by squaring, as every other eigenvalue is smaller.
Row limit_row(Matrix a) {
  const Matrix step = a;
  const double settled = 1e-16 * static_cast<double>(10 + a.cols());  // rounding of a row of so many entries
  for (int k = 0; k < 12; ++k) {
    const Row before = a.row(0);
    a *= a;
    for (Eigen::Index i = 0; i < a.rows(); ++i) a.row(i) /= a.row(i).sum();  // keeps row sums 1 through the rounding
    if ((a.row(0) - before).cwiseAbs().sum() >= settled) continue;
    if ((before * step - before).cwiseAbs().sum() < 1e-9) return a.row(0);  // an eigenvalue -1 settles under squaring only
    break;
  }
  throw Error(ErrorKind::word, "E_NO_LIMIT", "the points do not settle: the scheme seems to diverge or to oscillate",
              "prove converges(word) tells more");
}

// The matrices of the rounds on the neighbourhood of one vertex, up to where they repeat.
class Settling {
 public:
  Settling(const Word& word, int rings, const RunControl& control)
      : word_(word), rings_(rings), control_(control), first_item_(first_tail_item(word, control)) {}

  // Runs from `start`; afterwards `steps` take its points to those of `last`, and `repeating` takes `last` to itself.
  void settle(const Neighbourhood& start) {
    last = start;
    const bool stationary = is_stationary(word_);
    int item = first_item_;
    for (int round = 0; round < settling_rounds + drifting_rounds; ++round, item += static_cast<int>(word_.tail.size())) {
      Neighbourhood next;
      const Matrix step = refine(last, item, next);
      if (next.signature == last.signature && (stationary || round >= drifting_rounds)) {
        repeating = step;
        return;
      }
      if (stationary && round >= settling_rounds) break;
      steps.push_back(step);
      last = std::move(next);
    }
    throw Error(ErrorKind::word, "E_NO_LIMIT",
                "the neighbourhood of a vertex does not repeat after " + std::to_string(settling_rounds) + " rounds",
                "refine a few rounds first: (mesh |> word^3) |> limit(word)");
  }

  // Rows on `last` as rows on the start: the limit point, and tangents whose sum is 0. Every step halves a tangent or so, but not
  // the rounding of its sum, which many steps would make all there is; so it is taken out at every step.
  void pull_back(Row& point, std::array<Row, 2>& tangent) const {
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
      point = point * *step;
      point /= point.sum();
      for (Row& row : tangent) {
        row = row * *step;
        row -= row.sum() * point;
        const double size = row.cwiseAbs().sum();
        if (size > 0) row /= size;  // weights of the order of one, whatever the number of rounds
      }
    }
  }

  std::vector<Matrix> steps;
  Matrix repeating;
  Neighbourhood last;

 private:
  Matrix refine(const Neighbourhood& from, int item, Neighbourhood& to) const {
    const auto n = static_cast<Eigen::Index>(from.vertex.size());
    Surface<double> surface{std::make_shared<const Mesh>(from.mesh), Points<double>::Identity(n, n), from.tags, {}};
    const Surface<double> fine = run(word_, std::move(surface), 1, from_item(item, control_));
    to = neighbourhood(*fine.mesh, fine.tags, 0, rings_);
    Matrix step(static_cast<Eigen::Index>(to.vertex.size()), n);
    for (std::size_t k = 0; k < to.vertex.size(); ++k) step.row(static_cast<Eigen::Index>(k)) = fine.points.row(to.vertex[k]);
    return step;
  }

  const Word& word_;
  int rings_;
  const RunControl& control_;
  int first_item_;
};

// Twice the signed area of the faces around the centre, in the plane of two coordinate vectors.
double orientation(const Mesh& mesh, const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  double area = 0;
  for (int h = 0; h < mesh.half_edges(); ++h) {
    const int f = mesh.face[at(h)];
    const auto corners = mesh.corners(f);
    if (std::find(corners.begin(), corners.end(), 0) == corners.end()) continue;
    const int a = mesh.vertex[at(h)], b = mesh.tip(h);
    area += (x[a] - x[0]) * (y[b] - y[0]) - (x[b] - x[0]) * (y[a] - y[0]);
  }
  return area;
}

// Indices of the local vertices on the boundary curve near the centre. Its points depend on one another only.
std::vector<int> boundary_curve(const Neighbourhood& local, int rings) {
  const Mesh& mesh = local.mesh;
  std::vector<int> curve{0};
  int v = 0;
  for (int k = 0; k < rings; ++k) curve.push_back(v = mesh.tip(mesh.outgoing[at(v)]));
  v = 0;
  for (int k = 0; k < rings; ++k) curve.push_back(v = mesh.vertex[at(mesh.boundary_arrival(v))]);
  return curve;
}

// A left eigenvector on the boundary curve as a row on the whole neighbourhood.
Row spread(const Eigen::VectorXd& on_curve, const std::vector<int>& curve, Eigen::Index size) {
  Row row = Row::Zero(size);
  for (std::size_t k = 0; k < curve.size(); ++k) row[curve[k]] += on_curve[static_cast<Eigen::Index>(k)];
  return row;
}

Matrix restrict(const Matrix& a, const std::vector<int>& index) {
  Matrix result(static_cast<Eigen::Index>(index.size()), static_cast<Eigen::Index>(index.size()));
  for (std::size_t i = 0; i < index.size(); ++i)
    for (std::size_t j = 0; j < index.size(); ++j)
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = a(index[i], index[j]);
  return result;
}

// Two rows that span the tangent plane, and the groups of eigenvalues that they belong to.
struct Tangents {
  Eigen::MatrixXd rows;
  ModeGroup first, second;
};

// Inside: the left eigenvectors of the two eigenvalues below 1, if no third one has their modulus.
std::optional<Tangents> inner_tangents(const Matrix& a) {
  const std::vector<ModeGroup> groups = mode_groups(a);
  if (groups.size() < 2 || groups[1].algebraic > 2) return std::nullopt;
  const Matrix first = left_eigenvectors(a, groups[1]);
  if (first.cols() == 2) return Tangents{first.transpose(), groups[1], groups[1]};
  if (first.cols() != 1 || groups[1].algebraic != 1 || groups.size() < 3 || groups[2].algebraic != 1) return std::nullopt;
  const Matrix second = left_eigenvectors(a, groups[2]);
  if (second.cols() != 1) return std::nullopt;
  Tangents result{Matrix(2, a.rows()), groups[1], groups[2]};
  result.rows << first.transpose(), second.transpose();
  return result;
}

// On the boundary: the tangent of the boundary curve (both one-sided tangents at a corner), and the strongest direction across.
std::optional<Tangents> boundary_tangents(const Matrix& a, const Neighbourhood& local, int rings) {
  const std::vector<int> curve = boundary_curve(local, rings);
  const Matrix along = restrict(a, curve);
  const std::vector<ModeGroup> curve_groups = mode_groups(along);
  if (curve_groups.size() < 2) return std::nullopt;
  const Matrix tangent = left_eigenvectors(along, curve_groups[1]);
  Tangents result{Matrix(2, a.rows()), curve_groups[1], curve_groups[1]};
  if (tangent.cols() < 1 || tangent.cols() > 2) return std::nullopt;
  result.rows.row(0) = spread(tangent.col(0), curve, a.rows());
  if (tangent.cols() == 2) {
    result.rows.row(1) = spread(tangent.col(1), curve, a.rows());
    return result;
  }
  // The strongest group that holds more than the boundary tangent; a plane only if it holds one direction more.
  const std::vector<ModeGroup> groups = mode_groups(a);
  for (std::size_t k = 1; k < groups.size(); ++k) {
    Matrix left = left_eigenvectors(a, groups[k]);
    if (left.cols() == 0) return std::nullopt;  // directions that turn or change sides with every round
    const Row first = result.rows.row(0).normalized();
    left -= first.transpose() * (first * left);
    const double largest = left.cwiseAbs().maxCoeff();
    if (largest < 1e-7) continue;
    const Eigen::ColPivHouseholderQR<Matrix> qr(left);
    const Eigen::Index rank = (qr.matrixR().diagonal().array().abs() > 1e-6 * left.colwise().norm().maxCoeff()).count();
    if (rank != 1) return std::nullopt;
    result.rows.row(1) = left.col(qr.colsPermutation().indices()[0]).transpose();
    result.second = groups[k];
    return result;
  }
  return std::nullopt;
}

LimitStencil stencil_of(const Word& word, const Neighbourhood& start, int rings, const RunControl& control) {
  Settling settling(word, rings, control);
  settling.settle(start);
  const Matrix& a = settling.repeating;
  const Mesh& mesh = settling.last.mesh;
  LimitStencil result;
  result.point = limit_row(a);
  for (Row& row : result.tangent) row = Row::Zero(result.point.size());
  const std::optional<Tangents> tangents = mesh.on_boundary(0) ? boundary_tangents(a, settling.last, rings) : inner_tangents(a);
  if (tangents) {
    const Matrix answers = right_answers(a, tangents->rows, tangents->first, tangents->second);
    const bool clockwise = orientation(mesh, answers.col(0), answers.col(1)) < 0;
    for (std::size_t k = 0; k < 2; ++k) {
      Row& row = result.tangent[k] = tangents->rows.row(static_cast<Eigen::Index>(clockwise ? 1 - k : k));
      row /= row.cwiseAbs().sum();
    }
  }
  settling.pull_back(result.point, result.tangent);
  return result;
}

Eigen::Vector3d cross(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Rings of faces that the point and tangents depend on, from the reach of one round; one more where f looks at valences.
int rings_of(const Word& word) {
  const Reach reach = reach_of_round(word);
  const int a = arity(word);
  bool f_by_valence = false;
  for (const Item& item : word.tail)
    for (const KernelPtr& kernel : {item.f.plain, item.f.latitude, item.f.longitude})
      f_by_valence |= kernel && kernel->needs().valence;
  if (a < 2)
    throw Error(ErrorKind::word, "E_NO_LIMIT", "a round of the word has no U, so its points do not approach a curve or surface",
                "start the round with U");
  return std::max(1, (std::max(reach.high, -reach.low) + a - 2) / (a - 1)) + (f_by_valence ? 1 : 0) +
         (word.rings == Rings::off ? 0 : 2);
}

}  // namespace

int limit_rings(const Word& word) {
  validate(word);
  require_limit(word);
  return rings_of(word);
}

LimitStencil limit_stencil(const Word& word, const Neighbourhood& around, const RunControl& control) {
  return stencil_of(word, around, limit_rings(word), control);
}

Limit limit(const Word& word, const Surface<double>& surface, const RunControl& control) {
  const int vertices = surface.mesh->vertices(), rings = limit_rings(word);
  const Surface<double> base = word.head.empty() || control.first_item > 0 ? surface : run(word, surface, 0, control);
  if (word.triangles && !base.mesh->all_faces_have(3)) run(word, surface, 1, control);  // throws, naming the face
  std::map<std::vector<int>, LimitStencil> known;
  Limit result{Points<double>(vertices, 3), Points<double>(vertices, 6), Points<double>(vertices, 3)};
  Points<double> points = Points<double>::Zero(base.points.rows(), 3);
  points.leftCols(base.points.cols()) = base.points;
  for (int v = 0; v < vertices; ++v) {
    const Neighbourhood local = neighbourhood(*base.mesh, base.tags, base.mesh->outgoing[at(v)], rings);
    auto found = known.find(local.signature);
    if (found == known.end()) {
      throw_if_stopped(control.stop);
      found = known.emplace(local.signature, stencil_of(word, local, rings, control)).first;
    }
    const auto apply = [&](const Row& row) {
      Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
      for (std::size_t k = 0; k < local.vertex.size(); ++k)
        sum += row[static_cast<Eigen::Index>(k)] * points.row(local.vertex[k]);
      return sum;
    };
    const LimitStencil& stencil = found->second;
    const Eigen::RowVector3d a = apply(stencil.tangent[0]), b = apply(stencil.tangent[1]);
    result.points.row(v) = apply(stencil.point);
    result.tangents.row(v) << a, b;
    const Eigen::Vector3d normal = cross(a, b);
    const double length = normal.norm();
    const bool parallel = length <= 1e-12 * a.norm() * b.norm();
    result.normals.row(v) = parallel ? Eigen::RowVector3d::Zero().eval() : Eigen::RowVector3d(normal.transpose() / length);
    if (control.progress && v % 1024 == 0) control.progress(static_cast<double>(v) / vertices);
  }
  return result;
}

namespace {

// Points i - r .. i + r of a curve, cut at open ends; as an open curve whose own ends play no part in the limit.
struct Window {
  Polyline<double> curve;
  std::vector<int> index;
  int centre = 0;
};

Window window(const Polyline<double>& curve, int i, int reach) {
  Window result;
  const int n = curve.size();
  for (int k = i - reach; k <= i + reach; ++k) {
    if (!curve.closed && (k < 0 || k >= n)) continue;
    const int j = (k % n + n) % n;
    if (k == i) result.centre = static_cast<int>(result.index.size());
    result.index.push_back(j);
    result.curve.corner.push_back(curve.is_corner(j) ? 1 : 0);
  }
  result.curve.closed = false;
  return result;
}

// The window of the same point one round later, and the matrix between the two.
Matrix refine_window(const Word& word, const Window& from, int item, int reach, const RunControl& control, Window& to) {
  const auto n = static_cast<Eigen::Index>(from.index.size());
  Polyline<double> curve = from.curve;
  curve.points = Points<double>::Identity(n, n);
  const Polyline<double> fine = run(word, std::move(curve), 1, from_item(item, control));
  to = window(fine, from.centre * arity(word), reach);
  Matrix step(static_cast<Eigen::Index>(to.index.size()), n);
  for (std::size_t k = 0; k < to.index.size(); ++k) step.row(static_cast<Eigen::Index>(k)) = fine.points.row(to.index[k]);
  return step;
}

Row curve_stencil(const Word& word, Window from, int reach, const RunControl& control) {
  Matrix power = Matrix::Identity(static_cast<Eigen::Index>(from.index.size()), static_cast<Eigen::Index>(from.index.size()));
  const bool stationary = is_stationary(word);
  int item = first_tail_item(word, control);
  for (int round = 0; round < settling_rounds + drifting_rounds; ++round, item += static_cast<int>(word.tail.size())) {
    Window next;
    const Matrix step = refine_window(word, from, item, reach, control, next);
    const bool repeats = step.rows() == step.cols() && next.centre == from.centre && next.curve.corner == from.curve.corner;
    if (repeats && (stationary || round >= drifting_rounds)) {
      Matrix a = step;
      a.row(0).swap(a.row(from.centre));
      a.col(0).swap(a.col(from.centre));
      Row row = limit_row(a);
      std::swap(row[0], row[from.centre]);
      return row * power;
    }
    power = step * power;
    from = std::move(next);
  }
  throw Error(ErrorKind::word, "E_NO_LIMIT", "the neighbourhood of a point does not repeat",
              "refine a few rounds instead: curve |> word^8");
}

}  // namespace

Points<double> limit(const Word& word, const Polyline<double>& curve, const RunControl& control) {
  validate_for_curve(word);
  require_limit(word);
  const int reach = rings_of(word) + 1;
  const Polyline<double> base = word.head.empty() || control.first_item > 0 ? curve : run(word, curve, 0, control);
  const int factor = curve.closed ? base.size() / curve.size() : (base.size() - 1) / std::max(1, curve.size() - 1);
  std::map<std::pair<std::vector<char>, int>, Row> known;
  Points<double> result(curve.size(), curve.points.cols());
  for (int i = 0; i < curve.size(); ++i) {
    const Window local = window(base, factor * i, reach);
    const auto key = std::pair{local.curve.corner, local.centre};
    auto found = known.find(key);
    if (found == known.end()) found = known.emplace(key, curve_stencil(word, local, reach, control)).first;
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(curve.points.cols());
    for (std::size_t k = 0; k < local.index.size(); ++k)
      sum += found->second[static_cast<Eigen::Index>(k)] * base.points.row(local.index[k]);
    result.row(i) = sum;
  }
  return result;
}

}  // namespace udcp
