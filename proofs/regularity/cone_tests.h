// What the regularity theorems say of one net: the vectors that each test compares, what makes a witness valid, and the normal at
// corners. Shared by the search and its checker; nothing here is found by trying.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/regularity/bicubic_net.h"

namespace udcp {

/// T2: the differences of the patch. T3: those of its Bezier net. T4: the Bernstein coefficients of S_u x S_v. Each implies the
/// next.
enum class RegularityTest { t2, t3, t4 };
std::string to_string(RegularityTest);  // "T2" ..
std::optional<RegularityTest> regularity_test_from(const std::string& name);

/// Why a net is regular. In the plane: the one sign of all determinants. In space: n with n.u > 0 > n.v and m with m.u, m.v > 0
/// (T2, T3), or n with n.w > 0 for all Bernstein coefficients w (T4).
struct RegularityWitness {
  int sign = 0;
  std::optional<Vector3> n, m;
};
/// The witness proves the net regular by this test; everything exact.
bool is_witness(const RegularityWitness& witness, const BicubicNet& net, RegularityTest test, bool planar);

/// The non-zero vectors that T2 or T3 compare; nothing if zero vectors may not be ignored.
struct ConeVectors {
  std::vector<Vector3> u, v;
};
std::optional<ConeVectors> cone_vectors(const BicubicNet& net, RegularityTest test);
/// The non-zero Bernstein coefficients; nothing if one at a corner is zero.
std::optional<std::vector<Vector3>> normal_vectors(const BicubicNet& net);
/// u x v for all pairs.
std::vector<Vector3> all_determinants(const ConeVectors& cones);

/// S_u x S_v at the corner u = c, v = r, times 144.
Vector3 corner_normal(const BicubicNet& net, int r, int c);

/// The part of the unit square that a path of child digits leads to.
struct ParameterSquare {
  Rational u, v, size;
};
ParameterSquare square_of(const std::string& path);

}  // namespace udcp
