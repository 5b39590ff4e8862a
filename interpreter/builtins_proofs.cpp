// Claims and engines of later versions: their arguments are checked for unknown names, then they say that they are not available.
#include "interpreter/builtins.h"
#include "interpreter/statements.h"

namespace udcp {

namespace {

Value later(CallContext& context, const grammar::Call& call) {
  for (const grammar::Argument& argument : call.arguments) check_names(*argument.value, context);
  throw not_available(call.name);
}

Builtin engine(std::string_view name, std::string_view signature, std::string_view help) {
  return {name, signature, help, 0, 0, {}, nullptr, later};
}

}  // namespace

std::vector<Builtin> builtins_proofs() {
  return {
      engine("converges", "converges(word)", "Claim: the scheme converges to continuous limits."),
      engine("c1", "c1(word)", "Claim: limits have continuous tangents."),
      engine("c", "c(k)", "Claim: limits have k continuous derivatives."),
      engine("equal", "equal(word, word)", "Claim: two words give the same limits."),
      engine("regular", "regular(mesh, word)", "Claim: the limit surface is regular everywhere."),
      engine("eigen", "eigen(word, N = valence)", "Eigenvalues of the subdivision matrix at a vertex."),
      engine("spectrum", "spectrum(word, N = valence)", "Eigenvalues by Fourier blocks."),
      engine("reproduces", "reproduces(word, functions)", "Claim: the scheme reproduces these functions."),
      engine("generates", "generates(word, functions)", "Claim: the limits contain these functions."),
      engine("region", "region(claim)", "The parameters for which a claim holds."),
      engine("curvature", "curvature(mesh, word)", "Curvature of the limit surface."),
      engine("differences", "differences(mesh, word)", "Difference vectors of the regularity criterion."),
      engine("cones", "cones(mesh, word)", "Cones of the regularity criterion."),
      engine("interpolate", "interpolate(mesh, normals = no)", "A control mesh whose limit passes through the vertices."),
      engine("offset", "offset(mesh, distance, tolerance)", "A control mesh whose limit is an offset surface."),
      engine("offset_error", "offset_error(mesh, mesh)", "How far an offset is from its distance."),
      engine("self_intersections", "self_intersections(mesh)", "Pairs of faces that meet where they should not."),
      engine("fill_g2", "fill_g2(mesh)", "Fills an n-sided hole with curvature continuity."),
  };
}

}  // namespace udcp
