// Certificates of regularity: decides patches, then rings; words for what was found.
#include "proofs/regularity/regular_surface.h"

#include <algorithm>

#include "operators/interrupt.h"
#include "proofs/regularity/adaptive.h"
#include "proofs/regularity/certificate_json.h"
#include "proofs/regularity/covered_surface.h"
#include "proofs/regularity/global_test.h"
#include "proofs/regularity/ring_search.h"
#include "proofs/regularity/singular_points.h"

namespace udcp {
namespace {

using Status = AdaptiveResult::Status;

/// Leaves by patch.
Json leaves_json(const AdaptiveResult& result, std::size_t patches, RegularityTest test) {
  std::vector<Json> lists(patches, Json::array());
  for (const RegularLeaf& leaf : result.leaves)
    lists[static_cast<std::size_t>(leaf.patch)].push_back(to_json(leaf.path, test, leaf.witness));
  Json all = Json::array();
  for (Json& list : lists) all.push_back(std::move(list));
  return all;
}

Json levels_json(const AdaptiveResult& result) {
  Json levels = Json::array();
  for (const auto& [tested, passed] : result.per_level) levels.push_back(Json{{"tested", tested}, {"passed", passed}});
  return levels;
}

class Prover {
 public:
  Prover(const Surface<Rational>& surface, const RegularityOptions& options) : options_(options), mesh_json_(to_json(surface)) {
    result_.claim = name_of_surface(mesh_json_, options.mode) + " is regular";
    prepare(surface);
  }

  Result prove() {
    describe();
    decide();
    result_.details["T1"] = to_string(global().status);
    return std::move(result_);
  }

 private:
  void decide() {
    if (covered_->patches.empty() && covered_->rings.empty()) {
      result_.reason =
          "inapplicable: no face of the mesh is a patch" +
          std::string(options_.mode == RegularityMode::interior ? ", as none has four interior vertices of valence 4" : "");
      return;
    }
    if (prove_patches() && prove_rings()) finish();
  }

  /// T1 is not what decides, but what the paper tests.
  const GlobalResult& global() {
    if (!global_) global_ = test_globally(covered_->mesh);
    return *global_;
  }

  void progress(const std::string& what, double share) const {
    if (options_.progress) options_.progress(what, share);
  }

  /// Refines until extraordinary vertices are isolated; to the asked level where boundary vertices are not regular.
  void prepare(const Surface<Rational>& surface) {
    const bool quads = surface.mesh->all_faces_have(4);
    const bool can_refine = options_.mode == RegularityMode::bspline || is_closed(*surface.mesh);
    RunControl control;
    control.stop = options_.limits.stop;
    control.progress = [this](double share) { progress("refinement", share); };
    int steps = quads || !can_refine ? 0 : 1;
    covered_ = cover(surface, options_.mode, steps, control);
    while (!is_isolated(*covered_) && can_refine && steps < (quads ? 2 : 3))
      covered_ = cover(surface, options_.mode, ++steps, control);
    if (!covered_->uncovered.empty() && can_refine && steps < options_.steps)
      covered_ = cover(surface, options_.mode, options_.steps, control);
  }

  void describe() {
    const CoveredSurface& s = *covered_;
    result_.details =
        Json{{"mode", to_string(s.mode)},   {"test", to_string(options_.test)},         {"steps", s.steps},
             {"patches", s.patches.size()}, {"extraordinary_vertices", s.rings.size()}, {"uncovered_faces", s.uncovered}};
  }

  AdaptiveOptions adaptive(const std::string& what) const {
    AdaptiveOptions options;
    options.test = options_.test;
    options.depth = options_.depth;
    options.planar = covered_->mesh.is_planar();
    options.limits = options_.limits;
    options.progress = [this, what](double share) { progress(what, share); };
    return options;
  }

  bool prove_patches() {
    const CoveredSurface& s = *covered_;
    std::vector<BicubicNet> nets;
    std::vector<int> groups;
    const std::vector<int> group_of = s.mesh.groups(s.mode);
    for (const int f : s.patches) {
      nets.push_back(s.mesh.net(f));
      groups.push_back(group_of[static_cast<std::size_t>(f)]);
    }
    const AdaptiveResult found = decide_patches(nets, groups, adaptive("patches"));
    result_.details["depth"] = found.depth;
    result_.details["per_level"] = levels_json(found);
    patches_ = leaves_json(found, nets.size(), options_.test);
    if (found.status == Status::regular) return true;
    if (found.status == Status::undecided) return open(found), false;
    refuted(nullptr, points_json(found, s.patches));
    return false;
  }

  /// The points of a refutation; `faces` names the patches, which otherwise keep their numbers.
  static Json points_json(const AdaptiveResult& found, const std::vector<int>& faces) {
    Json points = Json::array();
    for (const SingularPoint& p : found.witness)
      points.push_back(Json{{"face", faces.empty() ? p.patch : faces[static_cast<std::size_t>(p.patch)]},
                            {"u", to_json(p.u)},
                            {"v", to_json(p.v)}});
    return points;
  }

  void open(const AdaptiveResult& found) {
    Json faces = Json::array();
    for (const int k : found.open) faces.push_back(covered_->patches[static_cast<std::size_t>(k)]);
    result_.reason = std::to_string(faces.size()) + (faces.size() == 1 ? " face" : " faces") + " of level " +
                     std::to_string(covered_->steps) + " neither regular nor singular ";
    result_.reason += found.out_of_budget
                          ? "when the search ended at its limits, depth " + std::to_string(found.depth)
                          : "down to depth " + std::to_string(found.depth) +
                                (covered_->mesh.is_planar()
                                     ? ": more depth decides, unless the surface touches a singularity without crossing it"
                                     : ": more depth proves a regular surface; a singular one is found at dyadic points only");
    result_.witness = Json{{"open_faces", std::move(faces)}};
  }

  void refuted(const Json& ring, Json points) {
    Json data{
        {"mesh", mesh_json_}, {"mode", to_string(options_.mode)}, {"steps", covered_->steps}, {"ring", ring}, {"points", points}};
    const std::string reason = describe_singularity(data, options_.limits.stop);
    accept(concluded(Verdict::refuted, reason,
                     seal("irregular-surface", irregular_statement(mesh_json_, options_.mode), std::move(data)),
                     options_.limits.stop));
    result_.witness = Json{{"ring", ring}, {"points", std::move(points)}};
  }

  /// A verdict with its certificate; the claim and the details stay those of the search.
  void accept(Result found) {
    found.details = std::move(result_.details);
    if (found.verdict != Verdict::proved) found.claim = std::move(result_.claim);
    result_ = std::move(found);
  }

  bool prove_rings() {
    Json levels = Json::array();
    for (const int v : covered_->rings) {
      throw_if_stopped(options_.limits.stop);
      if (!prove_ring(v)) return false;
      levels.push_back(Json{{"vertex", v}, {"level", rings_.back()["level"]}});
    }
    if (!levels.empty()) result_.details["rings"] = std::move(levels);
    return true;
  }

  bool prove_ring(int v) {
    const std::string place = "vertex " + std::to_string(v) + " of level " + std::to_string(covered_->steps);
    try {
      VertexRings rings = VertexRings::around(covered_->mesh.surface(), v);
      const RingResult found = decide_rings(rings, adaptive("rings of patches"));
      if (found.status == Status::regular) {
        Json list = Json::array();
        for (const AdaptiveResult& ring : found.rings)
          list.push_back(leaves_json(ring, static_cast<std::size_t>(3 * rings.valence()), options_.test));
        rings_.push_back(Json{{"vertex", v}, {"level", found.level}, {"rings", std::move(list)}});
        return true;
      }
      if (found.status == Status::undecided) {
        result_.reason = found.reason + ", at " + place;
        result_.witness = Json{{"vertex", v}, {"ring", found.level}};
      } else {
        refuted(Json{{"vertex", v}, {"ring", found.level}}, points_json(found.rings.back(), {}));
      }
    } catch (const Rejected& refusal) {  // a valence that the rings do not cover
      result_.reason = std::string(refusal.what()) + ", at " + place;
    }
    return false;
  }

  void finish() {
    const CoveredSurface& s = *covered_;
    if (!s.uncovered.empty() && (!options_.except_boundary || !leaves_out_boundary_only(s))) {
      result_.reason = "all other patches are regular, but nothing covers " + std::to_string(s.uncovered.size()) +
                       " faces of level " + std::to_string(s.steps) + " around vertices that are not regular" + advice();
      result_.witness = Json{{"uncovered_faces", s.uncovered}, {"around_vertices", s.uncovered_around}};
      return;
    }
    const bool embedded =
        s.steps == 0 && s.mode == RegularityMode::bspline && is_rectangle(s.mesh) && global().status == GlobalStatus::pass;
    Json separation = nullptr;
    if (embedded) separation = to_json(global().components.front());
    Json data{{"mesh", mesh_json_},
              {"mode", to_string(s.mode)},
              {"steps", s.steps},
              {"except_uncovered", !s.uncovered.empty()},
              {"patches", std::move(patches_)},
              {"rings", std::move(rings_)},
              {"global", std::move(separation)}};
    accept(concluded(Verdict::proved, reason_of_proof(),
                     seal("regular-surface", regular_statement(mesh_json_, s, embedded), std::move(data)), options_.limits.stop));
  }

  std::string advice() const {
    const CoveredSurface& s = *covered_;
    const auto has = [&](VertexClass c) {
      return std::any_of(s.uncovered_around.begin(), s.uncovered_around.end(), [&](int v) { return s.mesh.class_of(v) == c; });
    };
    if (has(VertexClass::smooth1)) return "; a boundary vertex with one face is always singular unless it is a corner";
    if (has(VertexClass::bextraordinary) || has(VertexClass::tagged))
      return "; no criterion is known for boundary vertices with more than two faces and for corners with more than one";
    return "; extraordinary vertices must have regular neighbours, and mode interior cannot refine an open mesh";
  }

  std::string reason_of_proof() const {
    const CoveredSurface& s = *covered_;
    std::string text = std::to_string(s.patches.size()) + (s.patches.size() == 1 ? " patch" : " patches") + " by " +
                       to_string(options_.test) + " at depth " + result_.details["depth"].dump();
    if (s.steps > 0) text += " after " + std::to_string(s.steps) + (s.steps == 1 ? " exact step" : " exact steps");
    if (!s.rings.empty()) {
      int most = 0;
      for (const Json& ring : result_.details["rings"]) most = std::max(most, ring["level"].get<int>());
      text += ", " + std::to_string(s.rings.size()) + " extraordinary " + (s.rings.size() == 1 ? "vertex" : "vertices") +
              " by rings up to level " + std::to_string(most);
    }
    return text;
  }

  const RegularityOptions& options_;
  Json mesh_json_;
  std::optional<CoveredSurface> covered_;
  std::optional<GlobalResult> global_;
  Json patches_, rings_ = Json::array();
  Result result_;
};

}  // namespace

Result prove_regular(const Surface<Rational>& surface, const RegularityOptions& options) {
  validate(surface);
  return Prover(surface, options).prove();
}

}  // namespace udcp
