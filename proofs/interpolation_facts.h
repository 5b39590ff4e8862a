// What the theorems on interpolation need to know, derived exactly from the running words: rows of the map to limits, control
// meshes and their limits, tangents at a vertex and what the corrections of its ring do to them. Shared by proofs and checkers.
#pragma once

#include <vector>

#include "operators/numbers/parametric.h"
#include "operators/surface.h"
#include "proofs/certificate.h"
#include "proofs/tangent_number.h"

namespace udcp {

/// What is claimed to interpolate: the two-level method with step 1 `global` (of control points W) or `local` (of vertices v1*),
/// and projecting corrections.
struct ExactInterpolation {
  Surface<Rational> cage;    // closed, every valence between 3 and largest_interpolation_valence
  Points<Rational> normals;  // a row per vertex, none of them 0
  bool global = false;
  Rational lambda;  // global
  bool tied = false;
};
inline constexpr int largest_interpolation_valence = 40;
inline constexpr int most_interpolation_vertices = 2'000;

/// {"mesh", "normals", "step1": "global" | "local", "lambda": "7/10" or null, "step2": "free" | "tied"}.
Json to_json(const ExactInterpolation& what);
/// Reads and checks it all; other entries are left to the caller. Throws Rejected.
ExactInterpolation interpolation_from(const Json& data);
/// Rows of numbers as lists of texts. Throws Rejected unless there are `count` rows of three.
Json to_json(const Points<Rational>& rows);
Points<Rational> rows_from(const Json& json, int count, const std::string& where);
/// Why the theorems do not speak of this input; empty if they do.
std::string not_covered(const ExactInterpolation& what);

/// M1 from its witness: W (global), the modified step of which it is, or the vertices of M1 (local), edge and face points being
/// those of the ordinary step of the cage.
Surface<Rational> first_refinement(const ExactInterpolation& what, const Points<Rational>& witness);

/// The ring of a vertex inside seen across its normal N: everything is in P_j = A e_j + f_(j-1) + f_j, as C2 + i C3 is
/// sum w^j P_j, w = exp(2 pi i/n). p_j = P_j . N, and the triple product (C2 x C3) . N divided by sin(2 pi/n).
struct ExactRing {
  int valence = 0;
  std::vector<TangentNumber> heights;  // p_j
  TangentNumber side;
};
ExactRing exact_ring(const Surface<Rational>& fine, int v, const Points<Rational>& normal);
/// The p_j after the correction (6) (or (5), tied), and whether the sums of the corrections of e and of f are 0, as it takes for
/// the limit point to stay.
struct CorrectedRing {
  std::vector<TangentNumber> heights;
  bool keeps_limit = false;
};
CorrectedRing corrected(const ExactRing& ring, bool tied);
/// C2 . N = C3 . N = 0.
bool is_flat(const std::vector<TangentNumber>& heights);

/// The weights (1) and (2) are left eigenvectors of the running word at this valence, of 1 and (4 + A)/16.
bool are_masks_eigenvectors(int valence);

/// The row of W -> limits of the modified step on quads at a vertex inside, in the parameter lambda: own v + edge sum e_j + face
/// sum (means of the faces at v, v included).
struct ExactLimitRow {
  Parametric own, edge, face;
};
ExactLimitRow exact_limit_row(int valence);
/// n(20 lambda - 7)/(13(n + 5)).
Parametric lambda_bound(int valence);
/// The row is what the theorem on lambda needs: it sums to 1; face is 3 edge, so that divided by edge the rows make a symmetric
/// matrix, in which a quad x contributes sum x_i x_(i+1) + 3/4 (sum x_i)^2 >= -sum x_i^2; all three are not negative for
/// 7/20 < lambda <= 1; and own - n edge is the bound. Then the eigenvalues on a closed quad mesh are real, at most 1 and at least
/// the smallest bound of its valences.
bool has_lambda_bound(const ExactLimitRow& row, int valence);

/// x = 1 on one colour and -1 on the other, with every edge between both: the quotient x K x / x D x of the symmetric matrices
/// above (K, with D = 1/edge on the diagonal), which no smallest eigenvalue exceeds. For closed quad meshes of valences >= 3.
/// Throws Rejected for other meshes and colours.
Rational checkerboard_quotient(const Mesh& mesh, const std::string& colours, const Rational& lambda);

/// Texts of statements.
std::string name_of_cage(const Json& data);
std::string interpolation_statement(const Json& data);
std::string reversed_statement(const Json& data, int vertex);
std::string threshold_statement(const std::vector<int>& valences);
std::string checkerboard_statement(const Json& data);
/// Faces of a mesh as lists, and back. Throws Rejected.
Json faces_to_json(const Mesh& mesh);
Mesh mesh_from(const Json& vertices, const Json& faces);

}  // namespace udcp
