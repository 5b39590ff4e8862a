// How far a Loop surface F = S + delta on the mesh of S is from the offset of S at a distance: sampled measures, which are exact
// at the samples, and upper bounds of max |eps| ("Offset approximation of Loop subdivision surfaces", section 3, and sharper
// ones).
#pragma once

#include <string_view>
#include <vector>

#include "operators/run.h"

namespace udcp {

/// Limits at the vertices of the `rounds` times refined mesh.
struct OffsetSamples {
  Surface<double> surface;  // refined control mesh of S
  Points<double> control;   // refined control vectors of delta
  Points<double> position, normal, delta;
};
/// Throws what run and limit_normals throw. `d` has a row per vertex.
OffsetSamples sample_offset(const Surface<double>& surface, const Points<double>& d, int rounds, const RunControl& control = {});

/// Measures at a point, with E = delta - distance n: eps = |delta| - |distance|; full = |E|; normal = E . n; slip = |E - (E . n)
/// n|.
enum class OffsetMeasure { eps, full, normal, slip };
std::string_view name_of(OffsetMeasure measure);
/// One value per sample, eps and normal with their signs.
std::vector<double> measure_offset(const OffsetSamples& samples, double distance, OffsetMeasure measure);

/// Largest moduli over the samples.
struct OffsetErrors {
  double eps = 0, full = 0, normal = 0, slip = 0;
  double rms = 0;  // of |E|
  double least_eps = 0, greatest_eps = 0;
  int worst = 0;  // the sample of largest |eps|
};
OffsetErrors offset_errors(const OffsetSamples& samples, double distance);
/// Largest |eps| per face of the mesh before `rounds` rounds.
std::vector<double> errors_by_face(const OffsetSamples& samples, double distance, int rounds);

/// The error of the distance from F to S, |dist(F, S) - |distance||, largest over the samples; S is searched over the samples'
/// triangles, and the foot point moved on the surface itself. Closest points beyond the triangles around the nearest are missed.
double foot_error(const OffsetSamples& samples, double distance, const RunControl& control = {});

/// Upper bounds of max |eps| from the control vectors around each face after `rounds` rounds: boxes (the paper's, of first
/// order), convex hulls (second order), Bernstein coefficients on regular patches (after one more round if a face has two
/// irregular vertices) and hulls elsewhere. Rounding errors are not bounded.
enum class OffsetBound { aabb, hull, bernstein };
std::string_view name_of(OffsetBound kind);
struct BoundedError {
  double bound = 0;
  int face = 0;  // of the mesh given, where the bound is largest
};
BoundedError bound_offset_error(const Surface<double>& surface, const Points<double>& d, double distance, OffsetBound kind,
                                int rounds = 0, const RunControl& control = {});

/// Branch and bound over patches, until every bound is at most 1.1 times the largest sample or `deepest` splits are made.
/// Rounding errors are not bounded; proofs/ repeats it outward-rounded. Throws Error{input, "E_NEEDS_REFINEMENT"} for boundary
/// vertices that are not regular, Error{limit, "E_MAX_PATCHES"}.
struct CertifiedError {
  double lower = 0, upper = 0;
  int patches = 0, depth = 0;
};
struct CertifiedErrors {
  CertifiedError eps, full;
};
CertifiedErrors certified_offset_errors(const Surface<double>& surface, const Points<double>& d, double distance,
                                        int deepest = 14, const RunControl& control = {});

/// One round first if some face has two irregular vertices or one on the boundary, on fields of any columns.
Surface<double> separated(const Surface<double>& surface, const RunControl& control = {});

}  // namespace udcp
