// A plan on points: gather the points of a neighbourhood, multiply, write the block; corners from closed formulas.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "operators/plan/block.h"
#include "operators/plan/corners.h"
#include "operators/plan/parallel.h"
#include "operators/plan/plan.h"

namespace udcp {
namespace {

std::size_t at(std::int64_t k) { return static_cast<std::size_t>(k); }

constexpr std::int64_t numbers_per_piece = 1 << 16;  // of a result: enough work to hide a lock, small enough to stop soon
/// One thread's work: face by face.
template <class R, int N>
class FaceWork {
 public:
  FaceWork(const Plan<R>& plan, const ResultNumbers<N>& numbers, const double* points, FlatMesh<R>& result)
      : plan_(plan), numbers_(numbers), block_{plan.segments}, points_(points), result_(result) {}

  void run(std::int64_t first_job, std::int64_t last_job) {
    const auto after = std::upper_bound(plan_.kinds.begin(), plan_.kinds.end(), first_job,
                                        [](std::int64_t job, const auto& kind) { return job < kind.first_job; });
    std::size_t k = at(after - plan_.kinds.begin()) - 1;
    for (std::int64_t job = first_job; job < last_job; ++job) {
      while (k + 1 < plan_.kinds.size() && plan_.kinds[k + 1].first_job <= job) ++k;
      gather(plan_.kinds[k], job);
      make_points(plan_.kinds[k]);
      if (plan_.content.tangents) make_normals(plan_.kinds[k]);
    }
  }

 private:
  using Kind = typename Plan<R>::Kind;
  typedef double Four __attribute__((vector_size(4 * sizeof(double)), aligned(alignof(double)), may_alias));
  typedef R FourR __attribute__((vector_size(4 * sizeof(R))));

  // Differences to the first point, taken in double: all rows for points have sum 1 and those for tangents sum 0, so the rounding
  // of a float result is that of its own digits, however far from the origin a small face lies.
  void gather(const Kind& kind, std::int64_t job) {
    const auto columns = at(kind.layers[0].columns);
    const std::uint32_t* vertex = plan_.vertex.data() + kind.first_vertex + at(job - kind.first_job) * (columns + 1);
    face_ = plan_.face[at(job)];
    writes_ = plan_.writes[at(job)];
    rows_ = rows_written();
    const Four first = *reinterpret_cast<const Four*>(points_ + 4 * std::size_t{*vertex});
    const FourR origin = __builtin_convertvector(first, FourR);
    std::memcpy(origin_.data(), &origin, sizeof origin);
    around_.resize(columns * 4);
    R* to = around_.data();
    for (std::size_t k = 1; k <= columns; ++k, to += 4) {
      const Four point = *reinterpret_cast<const Four*>(points_ + 4 * std::size_t{vertex[k]});
      const FourR difference = __builtin_convertvector(point - __builtin_convertvector(origin, Four), FourR);
      std::memcpy(to, &difference, sizeof difference);
    }
    for (std::size_t layer = 0; layer < kind.layers.size(); ++layer) {
      const std::size_t size = numbers_before(kind.layers[layer].panels());
      if (made_[layer].size() < size) made_[layer] = Buffer<R>(size);
    }
  }

  // Up to the last row that this face writes: what faces share is written by one of them, and the others need not compute it.
  [[nodiscard]] int rows_written() const {
    for (int k = N; k-- > 0;)
      if (writes_corner(k)) return block_.corner_row(k) + 1;
    for (int k = N; k-- > 0;)
      if (writes_edge(k)) return block_.edge_row(k + 1);
    return block_.interior();
  }
  [[nodiscard]] bool writes_edge(int k) const { return (writes_ >> k & 1U) != 0; }
  [[nodiscard]] bool writes_corner(int k) const { return (writes_ >> (N + k) & 1U) != 0; }

  static std::size_t numbers_before(int panel) { return at(panel) * 3 * panel_rows<R>; }
  [[nodiscard]] int panels_written() const { return (rows_ + panel_rows<R> - 1) / panel_rows<R>; }

  // Panels inside the face go straight to their place.
  void make_points(const Kind& kind) {
    const int inside = block_.interior() / panel_rows<R>;
    R* place = result_.points.data() + 3 * std::size_t{numbers_.in_face(face_)};
    multiply(kind.layers[0], 0, inside, around_.data(), origin_.data(), place);
    R* made = made_[0].data();
    multiply(kind.layers[0], inside, panels_written(), around_.data(), origin_.data(), made + numbers_before(inside));
    write(made, inside * panel_rows<R>, result_.points.data());
  }

  void make_normals(const Kind& kind) {
    constexpr std::array<R, 3> origin{};
    for (const std::size_t layer : {1, 2})
      multiply(kind.layers[layer], 0, panels_written(), around_.data(), origin.data(), made_[layer].data());
    R* normals = made_[1].data();
    for (int row = 0; row < rows_; ++row) replace_by_normal(normals + 3 * row, made_[2].data() + 3 * row);
    write(normals, 0, result_.normals.data());
  }

  // a becomes the unit vector along a x b; 0 where they are parallel, as in limit().
  static void replace_by_normal(R* a, const R* b) {
    const double x = double(a[1]) * b[2] - double(a[2]) * b[1], y = double(a[2]) * b[0] - double(a[0]) * b[2],
                 z = double(a[0]) * b[1] - double(a[1]) * b[0];
    const double length = std::sqrt(x * x + y * y + z * z);
    const double size = std::sqrt((double(a[0]) * a[0] + double(a[1]) * a[1] + double(a[2]) * a[2]) *
                                  (double(b[0]) * b[0] + double(b[1]) * b[1] + double(b[2]) * b[2]));
    const double rounding = sizeof(R) == sizeof(float) ? 1e-6 : 1e-12;
    const double scale = length <= rounding * size ? 0 : 1 / length;
    a[0] = static_cast<R>(x * scale), a[1] = static_cast<R>(y * scale), a[2] = static_cast<R>(z * scale);
  }

  // Rows of the face, from one inside it on, to their places.
  void write(const R* rows, int first, R* target) const {
    const auto copy = [&](int row, int count, std::size_t place) {
      std::memcpy(target + 3 * place, rows + 3 * row, at(count) * 3 * sizeof(R));
    };
    copy(first, block_.interior() - first, std::size_t{numbers_.in_face(face_)} + at(first));
    for (int k = 0; k < N; ++k) {
      const int h = N * face_ + (k + plan_.turn[at(face_)]) % N;
      if (writes_edge(k)) copy(block_.edge_row(k), block_.n - 1, numbers_.in_edge(h));
      if (writes_corner(k)) copy(block_.corner_row(k), 1, at(plan_.mesh->vertex[at(h)]));
    }
  }

  const Plan<R>& plan_;
  const ResultNumbers<N>& numbers_;
  Block<N> block_;
  const double* points_;
  FlatMesh<R>& result_;

  int face_ = 0, rows_ = 0;
  unsigned writes_ = 0;            // as in Plan
  std::vector<R> around_;          // points around the face but the first, less the first, four numbers each
  std::array<R, 4> origin_;        // which is this
  std::array<Buffer<R>, 3> made_;  // per layer, the rows that did not go to their place
};

// x y z 0 per point.
Buffer<double> in_fours(const Points<double>& points) {
  Buffer<double> result(at(points.rows()) * 4);
  double* out = result.data();
  for (Eigen::Index v = 0; v < points.rows(); ++v)
    for (Eigen::Index c = 0; c < 4; ++c) *out++ = c < points.cols() ? points(v, c) : 0;
  return result;
}

// Makes room for what the plan fills, where there was none before.
template <class R>
void prepare(const Plan<R>& plan, FlatMesh<R>& result) {
  const auto size = at(plan.vertices()) * 3;
  if (result.points.size() == size && result.normals.size() == (plan.content.tangents ? size : 0)) return;
  result.points = {};
  result.normals = {};
  result.points = Buffer<R>(size);
  if (plan.content.tangents) result.normals = Buffer<R>(size);
}

template <class R, int N>
void make(const Plan<R>& plan, const Points<double>& points, FlatMesh<R>& result, bool with_corners, const PlanControl& control) {
  prepare(plan, result);
  Buffer<std::uint32_t> corners(with_corners ? at(plan.faces()) * N : 0);
  const Buffer<double> fours = in_fours(points);
  const ResultNumbers<N> numbers(*plan.mesh, plan.turn, plan.segments);
  const auto jobs = static_cast<std::int64_t>(plan.face.size());
  const std::int64_t size = std::max<std::int64_t>(1, numbers_per_piece / (plan.segments * plan.segments));
  const std::int64_t pieces = (jobs + size - 1) / size;
  const int parts = with_corners ? 2 : 1;  // of the work on the same faces
  for_each_piece(parts * pieces, control.threads, control.run, [&](std::int64_t piece) {
    const std::int64_t first = piece / parts * size, last = std::min(jobs, first + size);
    if (piece % parts == 0) {
      FaceWork<R, N>(plan, numbers, fours.data(), result).run(first, last);
    } else {
      numbers.write(static_cast<int>(first), static_cast<int>(last), corners.data());
    }
  });
  if (!with_corners) return;
  result.corners = std::move(corners);
  result.corners_per_face = N;
}

template <class R>
void make(const Plan<R>& plan, const Points<double>& points, FlatMesh<R>& result, bool with_corners, const PlanControl& control) {
  if (points.rows() != plan.mesh->vertices() || points.cols() < 1 || points.cols() > 3)
    throw Error(ErrorKind::input, "E_POINTS",
                "the plan needs " + std::to_string(plan.mesh->vertices()) + " points with one to three coordinates, got " +
                    std::to_string(points.rows()) + " with " + std::to_string(points.cols()));
  if (plan.corners_per_face == 3) {
    make<R, 3>(plan, points, result, with_corners, control);
  } else {
    make<R, 4>(plan, points, result, with_corners, control);
  }
}

}  // namespace

template <class R>
void execute_last(const Plan<R>& plan, const Points<double>& points, FlatMesh<R>& result, const PlanControl& control) {
  const bool connected =
      result.corners_per_face == plan.corners_per_face && result.corners.size() == at(plan.faces() * plan.corners_per_face);
  if (!connected) result.corners = {};
  make(plan, points, result, !connected, control);
}

Points<double> points_after(const RoundsBefore& before, const Points<double>& control_points, const PlanControl& control) {
  PlanControl silent = control;
  silent.run.progress = nullptr;
  silent.run.first_item = before.first_item;
  if (!before.plan) {
    Surface<double> surface = before.base;
    surface.points = control_points;
    return run(before.word, std::move(surface), before.rounds, silent.run).points;
  }
  const Plan<double>& plan = *before.plan;
  FlatMesh<double> made;
  if (plan.before.is_empty()) {
    make(plan, control_points, made, false, silent);
  } else {
    make(plan, points_after(plan.before, control_points, silent), made, false, silent);
  }
  Points<double> points(made.vertices(), control_points.cols());
  for (Eigen::Index v = 0; v < points.rows(); ++v)
    for (Eigen::Index c = 0; c < points.cols(); ++c) points(v, c) = made.points[3 * at(before.number[at(v)]) + at(c)];
  return points;
}

template <class R>
void execute(const Plan<R>& plan, const Points<double>& control_points, FlatMesh<R>& result, const PlanControl& control) {
  if (plan.before.is_empty()) return execute_last(plan, control_points, result, control);
  execute_last(plan, points_after(plan.before, control_points, control), result, control);
}

#define UDCP_INSTANTIATE(R)                                                                            \
  template void execute_last(const Plan<R>&, const Points<double>&, FlatMesh<R>&, const PlanControl&); \
  template void execute(const Plan<R>&, const Points<double>&, FlatMesh<R>&, const PlanControl&);
UDCP_INSTANTIATE(float)
UDCP_INSTANTIATE(double)
#undef UDCP_INSTANTIATE

}  // namespace udcp
