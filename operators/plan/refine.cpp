// The choice between a plan and the general path, and the general path in the same clothes.
#include "operators/plan/refine.h"

#include "operators/limit.h"

namespace udcp {
namespace {

template <class R>
Buffer<R> triples(const Points<double>& points) {
  Buffer<R> result(static_cast<std::size_t>(points.rows()) * 3);
  R* out = result.data();
  for (Eigen::Index v = 0; v < points.rows(); ++v)
    for (Eigen::Index c = 0; c < 3; ++c) *out++ = c < points.cols() ? static_cast<R>(points(v, c)) : R(0);
  return result;
}

// The first item that is still to come after `rounds` rounds.
int item_after(const Word& word, int rounds, int first_item) {
  if (first_item > 0) return first_item + rounds * static_cast<int>(word.tail.size());
  return word.items(rounds);
}

// What compile() left undone.
Surface<double> finish(const Word& word, Unplanned rest, int rounds, const PlanControl& control) {
  if (rest.done == 0 && !rest.head_done) return run(word, std::move(rest.surface), rounds, control.run);
  if (rest.done == rounds) return std::move(rest.surface);
  const Word planned = *planned_word(word);
  RunControl from = control.run;
  from.first_item = item_after(planned, rest.done, control.run.first_item);
  return run(planned, std::move(rest.surface), rounds - rest.done, from);
}

template <class R>
Refined<R> as_result(const Word& word, Surface<double> surface, int rounds, const PlanControl& control) {
  Refined<R> result;
  if (control.limit_points || control.normals) {
    RunControl from = control.run;
    from.first_item = item_after(word, rounds, control.run.first_item);
    Limit limits = limit(word, surface, from);
    if (control.limit_points) surface.points = std::move(limits.points);
    if (control.normals) result.normals = std::move(limits.normals);
  }
  const Mesh& mesh = *surface.mesh;
  const int corners = mesh.size(0);
  if (surface.points.cols() > 3 || corners > 4 || !mesh.all_faces_have(corners)) {
    result.mesh = std::move(surface);
    return result;
  }
  FlatMesh<R> flat;
  flat.points = triples<R>(surface.points);
  if (control.normals) flat.normals = triples<R>(result.normals);
  flat.corners = Buffer<std::uint32_t>(mesh.vertex.size());
  for (std::size_t h = 0; h < mesh.vertex.size(); ++h) flat.corners[h] = static_cast<std::uint32_t>(mesh.vertex[h]);
  flat.corners_per_face = corners;
  result.mesh = std::move(flat);
  result.normals = {};
  return result;
}

}  // namespace

template <class R>
Refined<R> refine(const Word& word, const Surface<double>& surface, int rounds, const PlanControl& control) {
  Compiled<R> compiled = compile<R>(word, surface, rounds, control);
  if (!compiled.plan) return as_result<R>(word, finish(word, std::move(compiled.rest), rounds, control), rounds, control);
  Refined<R> result;
  FlatMesh<R> flat;
  execute_last(*compiled.plan, compiled.points, flat, control);
  result.mesh = std::move(flat);
  return result;
}

#define UDCP_INSTANTIATE(R) template Refined<R> refine(const Word&, const Surface<double>&, int, const PlanControl&);
UDCP_INSTANTIATE(float)
UDCP_INSTANTIATE(double)
#undef UDCP_INSTANTIATE

}  // namespace udcp
