// The claims about surfaces of given meshes.
#include "interpreter/apply.h"
#include "interpreter/claims.h"
#include "operators/schemes.h"
#include "proofs/regularity/regular_surface.h"
#include "proofs/static_word.h"

namespace udcp {
namespace {

/// Whether the word is Catmull and Clark's, at all vertices and faces that the mesh and its refinements have.
bool is_catmull_clark(const Word& word, const Mesh& mesh) {
  if (!word.is_scheme() || !not_on_meshes(word).empty() || !is_static(word)) return false;
  std::set<int> valences = {4};
  for (int v = 0; v < mesh.vertices(); ++v)
    if (mesh.valence(v) >= 3) valences.insert(mesh.valence(v));
  for (int f = 0; f < mesh.faces(); ++f) valences.insert(mesh.size(f));
  const std::vector<int> list(valences.begin(), valences.end());
  return to_json(static_limit(word), list) == to_json(static_limit(schemes::catmull_clark()), list);
}

}  // namespace

Value claim_regular(CallContext& context, const Arguments& a) {
  const MeshValue& mesh = need_mesh(a, 0);
  if (context.domain && !context.domain->valences.empty())
    throw Error(ErrorKind::word, "E_DOMAIN", "regular(mesh) has no valence N to run over", "leave 'for N in' away");
  RegularityOptions options;
  options.mode = choice_or(a, "mode", {"bspline", "interior"}) == "bspline" ? RegularityMode::bspline : RegularityMode::interior;
  options.test = *regularity_test_from(choice_or(a, "test", {"T2", "T3", "T4"}));
  options.depth = whole_or(a, a.positional.size(), "depth", options.depth, 0, 30);
  options.except_boundary = choice_or(a, "except", {"nothing", "boundary"}) == "boundary";
  options.steps = whole_or(a, a.positional.size(), "steps", options.steps, 0, 6);
  options.limits.stop = context.stop.get();
  options.progress = context.output.progress;
  Surface<Rational> surface = as_rational(mesh);
  if (choice_or(a, "corners", {"one_face", "tagged"}) == "one_face") surface = with_one_face_corners(std::move(surface));
  if (a.get(1, "word") && !is_catmull_clark(need_word(a, 1).word, *surface.mesh))
    return claim_value(undecided("the limit surface is regular", "regularity is decided for catmull_clark only"));
  if (context.domain && context.domain->evidence_only)
    return claim_value(undecided("the limit surface is regular", "check has no numbers for this claim; write prove"));
  return claim_value(prove_regular(surface, options));
}

}  // namespace udcp
