// Searches behind the theorems on offsets: bounds come from doubles, decisions from enclosures.
#include "proofs/offset_proofs.h"

#include <algorithm>
#include <cmath>

#include "operators/methods/offset/loop_limit.h"
#include "operators/methods/offset/offset_error.h"
#include "proofs/budget.h"
#include "proofs/embedding_facts.h"
#include "proofs/offset_statements.h"

namespace udcp {
namespace {

constexpr int most_rounds = 4;
constexpr double seconds_per_face = 0.005;  // what enclosing the patches of a face takes, roughly

/// Reasons that say what would decide it.
constexpr const char* out_of_budget = "the search used up its time or its patches";

LoopMesh exact_mesh(const Surface<double>& surface) {
  validate_control_mesh(surface);
  return checked_loop_mesh(surface.mesh, exact_rows(surface.points));
}

/// Splits a patch until every part is accepted; the code is '0' for an accepted patch, '1' and four codes for a split one.
class ErrorSearch {
 public:
  ErrorSearch(const OffsetErrorTest& test, Budget& budget) : test_(test), budget_(budget) {}

  bool cover(const Points<Interval>& net, int depth, std::string& code) {
    if (!budget_.spend()) return false;
    if (test_.likely(net) && test_.accepts(net)) {
      code += '0';
      return true;
    }
    if (depth == deepest_patch) return false;
    code += '1';
    return std::ranges::all_of(test_.children(net), [&](const auto& child) { return cover(child, depth + 1, code); });
  }

 private:
  const OffsetErrorTest& test_;
  Budget& budget_;
};

/// Separates two patches: a letter per direction, or '/' and the codes of the four children of one of them against the other.
class PairSearch {
 public:
  PairSearch(const EmbeddingFacts& facts, Budget& budget) : facts_(facts), budget_(budget) {}

  bool separate(PatchPiece& a, PatchPiece& b, int depth, std::string& code) {
    if (!budget_.spend()) return false;
    for (int k = 0; k < plane_directions; ++k) {
      if (!EmbeddingFacts::are_separated(a, b, k)) continue;
      code += static_cast<char>('a' + k);
      return true;
    }
    if (depth == deepest_patch) return false;
    code += '/';
    const bool first = depth % 2 == 0;
    return std::ranges::all_of(facts_.parts(first ? a : b),
                               [&](PatchPiece& part) { return separate(first ? part : a, first ? b : part, depth + 1, code); });
  }

 private:
  const EmbeddingFacts& facts_;
  Budget& budget_;
};

/// The data of an embedding after so many rounds; null with the reason where it is not certified.
Json find_embedding(const LoopMesh& surface, int rounds, const SearchLimits& limits, Budget& budget, std::string& reason) {
  EmbeddingFacts facts(surface, rounds, limits.stop);
  Json axes = Json::array(), pairs = Json::array();
  for (int v = 0; v < facts.mesh().vertices(); ++v) {
    const std::array<int, 3> axis = facts.likely_axis(v);
    if (!budget.spend()) return reason = out_of_budget, nullptr;
    if (!facts.is_graph(v, axis)) {
      reason = "around vertex " + std::to_string(v) + " after " + std::to_string(rounds) +
               " rounds the surface is not seen to be a graph";
      return nullptr;
    }
    axes.push_back(Json::array({axis[0], axis[1], axis[2]}));
  }
  PairSearch search(facts, budget);
  for (const auto& [f, g] : facts.close_pairs()) {
    std::string code;
    if (!search.separate(facts.piece(f), facts.piece(g), 0, code)) {
      reason = "the faces " + std::to_string(f) + " and " + std::to_string(g) + " after " + std::to_string(rounds) +
               " rounds are not seen to be apart";
      return nullptr;
    }
    pairs.push_back(Json::array({f, g, code}));
  }
  return {{"rounds", rounds}, {"axes", std::move(axes)}, {"pairs", std::move(pairs)}};
}

}  // namespace

Result prove_offset_contraction(int valence, LocalSet set) {
  if (valence < 3 || valence > largest_contraction_valence(set))
    throw Error(ErrorKind::input, "E_DOMAIN",
                "contraction is computed for valences 3 to " + std::to_string(largest_contraction_valence(set)) + ", not " +
                    std::to_string(valence),
                "");
  const Algebraic bound = contraction_bound(valence, set);
  Json data = {{"word", loop_word({valence})}, {"valence", valence}, {"set", to_string(set)}, {"bound", to_json(bound)}};
  const std::string statement = contraction_statement(valence, set, bound);
  if (!(bound < Algebraic(1))) {
    Result result;
    result.verdict = Verdict::refuted;
    result.claim = contraction_claim(valence, set);
    result.reason = "where the vertices around are all different the moduli sum to " + bound.to_string() + " >= 1";
    result.witness = std::move(data);
    return result;
  }
  return concluded(Verdict::proved, "exact inverse of the local system, weights from the word",
                   seal("offset-contraction", statement, std::move(data)));
}

Result prove_offset_definite(int valence) {
  if (valence < 3 || valence > 200)
    throw Error(ErrorKind::input, "E_DOMAIN", "valences are 3 to 200 here, not " + std::to_string(valence), "");
  const Algebraic w = limit_weight(valence), half = Algebraic(valence) / Algebraic(2);
  const Algebraic bound = (w - half) / (w + Algebraic(valence));
  return concluded(Verdict::proved, "every edge lies in two triangles and every vertex in N, so A >= -diag(N)/2, and w > N/2",
                   seal("offset-definite", definite_statement(valence, bound),
                        {{"word", loop_word({valence})}, {"valence", valence}, {"bound", to_json(bound)}}));
}

Result prove_offset_error(const Surface<double>& surface, const Points<double>& d, const Rational& distance, bool full,
                          std::optional<Rational> bound, const SearchLimits& limits) {
  const Interval::Precision precision(offset_precision);
  Budget budget(limits);
  const LoopMesh points = exact_mesh(surface);
  if (d.rows() != surface.points.rows() || d.cols() != 3 || !d.allFinite())
    throw Error(ErrorKind::input, "E_POINTS", "there must be one finite control vector of three coordinates per vertex", "");
  if (!bound) {
    const OffsetErrors sampled = offset_errors(sample_offset(surface, d, 3), distance.to_double());
    bound = Rational::from_double(1.25 * (full ? sampled.full : sampled.eps) + 1e-12);
  }
  const Rational away = full || distance.sign() >= 0 ? distance : -distance;
  Json data = {{"word", loop_word(valences_of(*surface.mesh))},
               {"faces", triangles_to_json(*surface.mesh)},
               {"vectors", exact_rows_to_json(exact_rows(d))},
               {"distance", to_json(away)},
               {"measure", full ? "full" : "eps"},
               {"bound", to_json(*bound)}};
  if (full) data["points"] = exact_rows_to_json(points.points);  // lengths of delta do not depend on them
  const std::string statement = error_statement(data, away, full, *bound);
  LoopMesh both = points;
  both.points.resize(points.points.rows(), 6);
  both.points << points.points, exact_rows(d);
  try {
    const bool separate = std::ranges::any_of(surface.mesh->valences, [](int n) { return n != 6; });
    const EnclosedPatches patches = enclosed_patches(both, separate ? 1 : 0, limits.stop);
    const OffsetErrorTest test(*surface.mesh, away, full, *bound);
    ErrorSearch search(test, budget);
    Json cells = Json::array();
    for (std::size_t f = 0; f < patches.net.size(); ++f) {
      std::string code;
      if (!search.cover(patches.net[f], 0, code))
        return undecided(statement, "the bound does not hold, or is too close to decide, on face " + std::to_string(f) +
                                        (separate ? " after one round" : ""));
      cells.push_back(code);
    }
    data["rounds"] = separate ? 1 : 0;
    data["cells"] = std::move(cells);
    return concluded(Verdict::proved, "Bernstein coefficients and normal cones of all patches, outward-rounded",
                     seal("offset-error", statement, std::move(data)), limits.stop);
  } catch (const Rejected& reason) {
    return undecided(statement, reason.what());
  }
}

Result prove_embedded(const Surface<double>& surface, const SearchLimits& limits) {
  validate_control_mesh(surface);
  return prove_embedded(Surface<Rational>{surface.mesh, exact_rows(surface.points), surface.tags, {}}, limits);
}

Result prove_embedded(const Surface<Rational>& surface, const SearchLimits& limits) {
  const Interval::Precision precision(offset_precision);
  Budget budget(limits);
  std::string reason;
  validate_loop_mesh(*surface.mesh, surface.tags);
  Json data = {{"word", loop_word(valences_of(*surface.mesh))},
               {"faces", triangles_to_json(*surface.mesh)},
               {"points", exact_rows_to_json(surface.points)}};
  const std::string statement = embedded_statement(data);
  try {
    const LoopMesh points = checked_loop_mesh(surface.mesh, surface.points);
    const bool regular = std::ranges::all_of(surface.mesh->valences, [](int n) { return n == 6; });
    for (int rounds = regular ? 0 : 2; rounds <= most_rounds; ++rounds) {
      const long faces = static_cast<long>(surface.mesh->faces()) << (2 * rounds);
      const bool fits = faces <= 4L * most_faces && static_cast<double>(faces) * seconds_per_face <= limits.seconds;
      if (!fits || !budget.spend()) {
        if (reason.empty()) reason = "refining the mesh would take longer than the time allowed";
        break;
      }
      const Json found = find_embedding(points, rounds, limits, budget, reason);
      if (found.is_null()) continue;
      data.update(found);
      return concluded(Verdict::proved,
                       "discs around vertices are graphs over planes, and planes separate all other pairs of patches",
                       seal("embedded-surface", statement, std::move(data)), limits.stop);
    }
  } catch (const Rejected& refusal) {
    reason = refusal.what();
  }
  return undecided(statement, reason);
}

}  // namespace udcp
