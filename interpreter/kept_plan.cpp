// Words are the same if they share their kernels, which are never changed: two evaluations of one name do.
#include "interpreter/kept_plan.h"

#include <algorithm>

#include "operators/plan/correspondence.h"

namespace udcp {
namespace {

constexpr int worth_it = 20'000;  // faces of the result

template <class T>
bool same(const Directional<T>& a, const Directional<T>& b) {
  return a.plain == b.plain && a.latitude == b.latitude && a.longitude == b.longitude;
}

bool same(const Item& a, const Item& b) {
  return a.atom == b.atom && a.sections == b.sections && same(a.f, b.f) && a.f_everywhere == b.f_everywhere && a.ngon == b.ngon &&
         same(a.omega, b.omega) && a.omega_face == b.omega_face && a.delta == b.delta;
}

bool same(const std::vector<Item>& a, const std::vector<Item>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Item& x, const Item& y) { return same(x, y); });
}

bool same(const Word& a, const Word& b) {
  return same(a.head, b.head) && same(a.tail, b.tail) && same(a.alpha0, b.alpha0) && a.rings == b.rings &&
         a.triangles == b.triangles;
}

bool same(const Mesh& a, const Mesh& b) { return &a == &b || (a.face_begin == b.face_begin && a.vertex == b.vertex); }

bool same(const Tags& a, const Tags& b) { return a.edge == b.edge && a.corner == b.corner; }

bool is_plain(const Surface<double>& surface) { return surface.points.cols() == 3 && surface.attributes.empty(); }

}  // namespace

bool KeptPlan::fits(const Word& word, const Surface<double>& surface, int rounds) const {
  return base_ && rounds == rounds_ && is_plain(surface) && same(*base_, *surface.mesh) && same(base_tags_, surface.tags) &&
         same(word_, word);
}

void KeptPlan::remember(const Word& word, const Surface<double>& surface, int rounds, const Surface<double>& result) {
  if (fits(word, surface, rounds)) return;
  *this = {};
  if (!is_plain(surface) || result.mesh->faces() < worth_it) return;
  word_ = word;
  rounds_ = rounds;
  base_ = surface.mesh;
  base_tags_ = surface.tags;
  base_points_ = surface.points;
  result_ = result.mesh;
  result_points_ = result.points;
  result_tags_ = result.tags;
}

bool KeptPlan::make_plan(const PlanControl& control) {
  Compiled<double> compiled = compile<double>(word_, {base_, base_points_, base_tags_, {}}, rounds_, control);
  if (!compiled.plan) return false;
  execute(*compiled.plan, base_points_, frame_, control);
  counterpart_ = numbers_in_plan(*result_, half_edges_of(frame_), *compiled.plan->mesh);
  if (counterpart_.empty()) return false;
  const double apart = (frame_points() - result_points_).cwiseAbs().maxCoeff();
  if (!(apart <= 1e-9 * result_points_.cwiseAbs().maxCoeff())) return false;
  base_points_ = result_points_ = {};
  plan_ = std::move(compiled.plan);
  return true;
}

Points<double> KeptPlan::frame_points() const {
  Points<double> points(result_->vertices(), 3);
  for (std::size_t v = 0; v < counterpart_.size(); ++v) {
    const double* from = frame_.points.data() + 3 * Mesh::i(counterpart_[v]);
    std::copy(from, from + 3, points.data() + 3 * v);
  }
  return points;
}

std::optional<Surface<double>> KeptPlan::refine(const Word& word, const Surface<double>& surface, int rounds,
                                                const RunControl& control, int threads) {
  if (is_hopeless_ || !fits(word, surface, rounds)) return std::nullopt;
  PlanControl plan_control{control};
  plan_control.always = true;
  plan_control.threads = threads;
  if (!plan_ && !make_plan(plan_control)) {
    is_hopeless_ = true;
    return std::nullopt;
  }
  execute(*plan_, surface.points, frame_, plan_control);
  return Surface<double>{result_, frame_points(), result_tags_, {}};
}

}  // namespace udcp
