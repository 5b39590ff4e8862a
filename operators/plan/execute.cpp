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

constexpr std::int64_t numbers_per_piece = 1 << 16;      // of a result: enough work to hide a lock, small enough to stop soon
constexpr std::int64_t larger_than_caches = 32LL << 20;  // bytes; below, the next reader finds a result in the cache

constexpr std::int64_t faces_at_once = 8;  // that share a part of their matrix while it is in the first cache
constexpr int bytes_at_once = 16 << 10;    // of the matrix; half of a usual first cache, the rest is for points

/// One thread's work: a few faces of one kind at a time, and for them a few panels of their matrix at a time.
template <class R, int N>
class FaceWork {
 public:
  FaceWork(const Plan<R>& plan, const ResultNumbers<N>& numbers, const double* points, FlatMesh<R>& result, bool streams)
      : plan_(plan), numbers_(numbers), block_{plan.segments}, points_(points), result_(result), streams_(streams) {}

  void run(std::int64_t first_job, std::int64_t last_job) {
    const auto after = std::upper_bound(plan_.kinds.begin(), plan_.kinds.end(), first_job,
                                        [](std::int64_t job, const auto& kind) { return job < kind.first_job; });
    std::size_t k = at(after - plan_.kinds.begin()) - 1;
    for (std::int64_t job = first_job; job < last_job;) {
      while (k + 1 < plan_.kinds.size() && plan_.kinds[k + 1].first_job <= job) ++k;
      const std::int64_t kind_ends = k + 1 < plan_.kinds.size() ? plan_.kinds[k + 1].first_job : last_job;
      const std::int64_t end = std::min({last_job, kind_ends, job + faces_at_once});
      for (std::int64_t next = job; next < end; ++next) gather(plan_.kinds[k], next, faces_[at(next - job)]);
      make(plan_.kinds[k], at(end - job));
      job = end;
    }
  }

 private:
  using Kind = typename Plan<R>::Kind;
  struct Face {
    int f = 0;
    std::vector<R> points;    // around it, less the first of them
    std::array<R, 3> origin;  // which is this
    std::array<Buffer<R>, 3> block;
    std::size_t streamed = 0;  // numbers of the interior that are in their place
  };

  // Differences to the first point, taken in double: all rows for points have sum 1 and those for tangents sum 0, so the rounding
  // of a float result is that of its own digits, however far from the origin a small face lies.
  void gather(const Kind& kind, std::int64_t job, Face& face) {
    const auto columns = at(kind.layers[0].columns);
    const std::uint32_t* vertex = plan_.vertex.data() + kind.first_vertex + at(job - kind.first_job) * columns;
    face.f = plan_.face[at(job)];
    face.streamed = 0;
    face.points.resize(columns * 3);
    for (std::size_t c = 0; c < 3; ++c) face.origin[c] = static_cast<R>(points_[3 * std::size_t{vertex[0]} + c]);
    for (std::size_t k = 0; k < columns; ++k)
      for (std::size_t c = 0; c < 3; ++c)
        face.points[3 * k + c] = static_cast<R>(points_[3 * std::size_t{vertex[k]} + c] - double{face.origin[c]});
    const std::size_t size = numbers_before(kind.layers[0].panels());
    for (std::size_t layer = 0; layer < kind.layers.size(); ++layer)
      if (face.block[layer].size() < size) face.block[layer] = Buffer<R>(size);
  }

  static std::size_t numbers_before(int panel) { return at(panel) * 3 * panel_rows<R>; }

  void make(const Kind& kind, std::size_t faces) {
    const PanelMatrix<R>& matrix = kind.layers[0];
    const int panels = matrix.panels(), at_once = std::max(1, bytes_at_once / (64 * std::max(1, matrix.columns)));
    for (int first = 0; first < panels; first += at_once)
      for (std::size_t k = 0; k < faces; ++k) make_rows(kind, first, std::min(first + at_once, panels), faces_[k]);
    for (std::size_t k = 0; k < faces; ++k) {
      if (plan_.content.tangents) place_points_and_normals(faces_[k]);
      write_border(faces_[k].block[0].data(), result_.points.data(), faces_[k].f);
    }
  }

  // Rows inside the face go straight to their place or stream there behind the work; those of the border stay in the block.
  void make_rows(const Kind& kind, int first, int last, Face& face) {
    constexpr std::array<R, 3> nothing{};
    const std::size_t size = at(block_.interior()) * 3, begin = numbers_before(first), end = numbers_before(last);
    R* target = result_.points.data() + 3 * std::size_t{numbers_.in_face(face.f)};
    R* block = face.block[0].data();
    if (!streams_ && !plan_.content.tangents && end <= size) {
      multiply(kind.layers[0], first, last, face.points.data(), face.origin.data(), target + begin);
      return;
    }
    multiply(kind.layers[0], first, last, face.points.data(), face.origin.data(), block + begin);
    for (std::size_t layer = 1; layer < kind.layers.size(); ++layer)
      multiply(kind.layers[layer], first, last, face.points.data(), nothing.data(), face.block[layer].data() + begin);
    if (plan_.content.tangents || begin >= size) return;
    const std::size_t ready = std::min(size, end);
    if (streams_) {
      face.streamed += stream_copy(target + face.streamed, block + face.streamed, ready - face.streamed, ready == size);
    } else {
      std::memcpy(target + begin, block + begin, (ready - begin) * sizeof(R));
    }
  }

  void place_points_and_normals(Face& face) {
    R* normals = face.block[1].data();
    for (int row = 0; row < block_.points(); ++row) replace_by_normal(normals + 3 * row, face.block[2].data() + 3 * row);
    const std::size_t first = 3 * std::size_t{numbers_.in_face(face.f)}, size = at(block_.interior()) * 3 * sizeof(R);
    std::memcpy(result_.points.data() + first, face.block[0].data(), size);
    std::memcpy(result_.normals.data() + first, normals, size);
    write_border(normals, result_.normals.data(), face.f);
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

  // Of what two faces share, one of them writes: the one whose half-edge gives the edge its direction, or that the vertex names.
  void write_border(const R* block, R* target, int f) const {
    const Mesh& mesh = *plan_.mesh;
    for (int k = 0; k < N; ++k) {
      const int h = N * f + k, v = mesh.vertex[at(h)];
      if (numbers_.along(h) && plan_.segments > 1)
        std::memcpy(target + 3 * std::size_t{numbers_.in_edge(h)}, block + 3 * block_.edge_row(k),
                    at(plan_.segments - 1) * 3 * sizeof(R));
      if (mesh.outgoing[at(v)] == h) std::memcpy(target + 3 * at(v), block + 3 * block_.corner_row(k), 3 * sizeof(R));
    }
  }

  const Plan<R>& plan_;
  const ResultNumbers<N>& numbers_;
  Block<N> block_;
  const double* points_;
  FlatMesh<R>& result_;
  bool streams_;
  std::array<Face, faces_at_once> faces_;
};

Buffer<double> as_triples(const Points<double>& points) {
  Buffer<double> result(at(points.rows()) * 3);
  double* out = result.data();
  for (Eigen::Index v = 0; v < points.rows(); ++v)
    for (Eigen::Index c = 0; c < 3; ++c) *out++ = c < points.cols() ? points(v, c) : 0;
  return result;
}

// Makes room for what the plan fills; true where there was room before.
template <class R>
bool prepare(const Plan<R>& plan, FlatMesh<R>& result) {
  const auto size = at(plan.vertices()) * 3;
  const bool filled = result.points.size() == size && result.normals.size() == (plan.content.tangents ? size : 0);
  if (!filled) {
    result.points = {};
    result.normals = {};
    result.points = Buffer<R>(size);
    if (plan.content.tangents) result.normals = Buffer<R>(size);
  }
  return filled;
}

// Two kinds of work one after the other, as one in the eyes of control.progress.
RunControl part_of(const RunControl& control, double from, double to) {
  RunControl part = control;
  if (control.progress)
    part.progress = [report = control.progress, from, to](double fraction) { report(from + (to - from) * fraction); };
  return part;
}

template <class R, int N>
void execute_blocks(const Plan<R>& plan, const Buffer<double>& points, FlatMesh<R>& result, const PlanControl& control) {
  const bool filled = prepare(plan, result);
  const std::size_t corners = at(plan.faces()) * N;
  const bool connected = result.corners.size() == corners && result.corners_per_face == N;
  const ResultNumbers<N> numbers(*plan.mesh, plan.segments);
  const bool streams =
      filled && plan.vertices() * 3 * static_cast<std::int64_t>(sizeof(R)) > larger_than_caches && plan.segments > 4;
  const auto jobs = static_cast<std::int64_t>(plan.face.size());
  const std::int64_t per_piece = std::max<std::int64_t>(1, numbers_per_piece / (plan.segments * plan.segments));
  const std::int64_t pieces = (jobs + per_piece - 1) / per_piece;
  const double split = connected ? 1 : 0.5;
  for_each_piece(pieces, control.threads, part_of(control.run, 0, split), [&](std::int64_t piece) {
    FaceWork<R, N> work(plan, numbers, points.data(), result, streams);
    work.run(piece * per_piece, std::min(jobs, (piece + 1) * per_piece));
  });
  if (connected) return;
  result.corners = {};
  Buffer<std::uint32_t> filling(corners);
  for_each_piece(pieces, control.threads, part_of(control.run, split, 1), [&](std::int64_t piece) {
    numbers.write(static_cast<int>(piece * per_piece), static_cast<int>(std::min(jobs, (piece + 1) * per_piece)), filling.data());
  });
  result.corners = std::move(filling);
  result.corners_per_face = N;
}

}  // namespace

template <class R>
void execute_last(const Plan<R>& plan, const Points<double>& points, FlatMesh<R>& result, const PlanControl& control) {
  if (points.rows() != plan.mesh->vertices() || points.cols() < 1 || points.cols() > 3)
    throw Error(ErrorKind::input, "E_POINTS",
                "the plan needs " + std::to_string(plan.mesh->vertices()) + " points with one to three coordinates, got " +
                    std::to_string(points.rows()) + " with " + std::to_string(points.cols()));
  const Buffer<double> triples = as_triples(points);
  if (plan.corners_per_face == 3) {
    execute_blocks<R, 3>(plan, triples, result, control);
  } else {
    execute_blocks<R, 4>(plan, triples, result, control);
  }
}

template <class R>
void execute(const Plan<R>& plan, const Points<double>& control_points, FlatMesh<R>& result, const PlanControl& control) {
  if (plan.before == 0 && !plan.head_before) return execute_last(plan, control_points, result, control);
  Surface<double> surface = plan.base;
  surface.points = control_points;
  RunControl before;
  before.first_item = plan.first_item;
  before.max_faces = control.run.max_faces;
  before.stop = control.run.stop;
  execute_last(plan, run(plan.word, std::move(surface), plan.before, before).points, result, control);
}

#define UDCP_INSTANTIATE(R)                                                                            \
  template void execute_last(const Plan<R>&, const Points<double>&, FlatMesh<R>&, const PlanControl&); \
  template void execute(const Plan<R>&, const Points<double>&, FlatMesh<R>&, const PlanControl&);
UDCP_INSTANTIATE(float)
UDCP_INSTANTIATE(double)
#undef UDCP_INSTANTIATE

}  // namespace udcp
