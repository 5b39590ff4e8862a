// The claims on Catmull-Clark surfaces through given points with given normals.
#include "interpreter/claims.h"
#include "interpreter/interpolation.h"
#include "proofs/interpolation_claims.h"

namespace udcp {
namespace {

bool is_evidence_only(const CallContext& context) { return context.domain && context.domain->evidence_only; }

Value no_numbers(const std::string& claim) {
  return claim_value(undecided(claim, "check has no numbers for this claim; write prove"));
}

}  // namespace

Value claim_interpolates(CallContext& context, const Arguments& a) {
  const MeshValue& mesh = need_mesh(a, 0);
  const std::string claim = "the surface passes exactly through every vertex and has there exactly its normal";
  if (is_evidence_only(context)) return no_numbers(claim);
  ExactInterpolation what;
  what.cage = as_rational(mesh);
  const InterpolateOptions options = interpolation_options(a, what.cage.mesh->vertices(), context);
  what.normals = normals_argument<Rational>(a, what.cage, mesh, context);
  check_normals(convert<double>(Surface<Rational>{what.cage.mesh, what.normals, {}, {}}).points, what.cage.mesh->vertices(), {});
  if (options.method != InterpolationMethod::two_level || options.step1 == PointStep::plain)
    return claim_value(undecided(claim, "the theorem is about method = two_level with step1 = global or local"));
  if (options.step2 == NormalStep::rotate)
    return claim_value(undecided(claim, "rotations have no exact numbers; the theorem is about step2 = free and tied"));
  what.global = options.step1 == PointStep::global;
  if (what.global) what.lambda = options.lambda;
  what.tied = options.step2 == NormalStep::tied;
  return claim_value(prove_interpolation(what, search_limits(context)));
}

Value claim_iteration_converges(CallContext& context, const Arguments& a) {
  if (is_evidence_only(context)) return no_numbers("the iteration over the mesh converges");
  if (a.get(0, "mesh")) {
    const MeshValue& value = need_mesh(a, 0);
    const auto connectivity = std::visit([](const auto& surface) { return surface.mesh; }, value.shape);
    return claim_value(
        prove_iteration_converges(*connectivity, interpolation_options(a, connectivity->vertices(), context).lambda));
  }
  const bool has_valences = context.domain && !context.domain->valences.empty();
  return claim_value(prove_lambda_range(has_valences ? context.domain->valences : std::vector<int>{3, 4, 5, 6, 7, 8}));
}

}  // namespace udcp
