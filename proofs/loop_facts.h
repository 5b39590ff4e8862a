// What proofs about Loop surfaces and their offsets derive from the running word: limit weights with the check that they are
// limits, meshes in certificates, patches in enclosures. Shared by searches and checkers; nothing here is found by trying.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "operators/methods/offset/loop_patch.h"
#include "proofs/static_word.h"

namespace udcp {

/// Loop's word as data, with the parameters at these valences and at 6, rising.
Json loop_word(std::vector<int> valences);
/// Rejected unless the data are exactly loop_word(valences).
void require_loop_word(const Json& word, std::vector<int> valences);

/// w such that (w v + sum of the ring)/(w + N) is the limit of a vertex of valence N: from one round on a fan of unit vectors,
/// where (w, 1, .. 1) must be a left eigenvector for 1. Exact. Throws Rejected.
Algebraic limit_weight(int valence);

/// Which vertices share a local system in the edge iteration: i and one regular neighbour, or i and all its neighbours.
enum class LocalSet { pair, star };
std::string to_string(LocalSet set);
/// Sum of the moduli of the coefficients of the old values outside the set, for a vertex of this valence in a mesh where all
/// other vertices have valence 6 and those outside the set are different. Where some coincide, coefficients are added, so the sum
/// can only be smaller. Exact. Valences 3 .. largest_contraction_valence(set).
Algebraic contraction_bound(int valence, LocalSet set);
int largest_contraction_valence(LocalSet set);

/// A closed mesh of triangles with rational control points (any columns), of valences 3 .. largest_patch_valence.
struct LoopMesh {
  std::shared_ptr<const Mesh> mesh;
  Points<Rational> points;
};
/// Throws Rejected unless it is one, with at most `most_faces` faces.
LoopMesh checked_loop_mesh(std::shared_ptr<const Mesh> mesh, Points<Rational> points);
inline constexpr int most_faces = 20'000;
/// All valences of the mesh, rising.
std::vector<int> valences_of(const Mesh& mesh);
/// {"faces": [[a, b, c], ..], "points": [[x, y, z], ..]} with exact numbers, and back.
Json triangles_to_json(const Mesh& mesh);
Json exact_rows_to_json(const Points<Rational>& rows);
std::shared_ptr<const Mesh> triangles_from(const Json& faces, int vertices);
Points<Rational> exact_rows_from(const Json& rows, int columns, const std::string& where);

/// The doubles as the rationals that they are. Error{input, "E_NOT_FINITE"}.
Points<Rational> exact_rows(const Points<double>& rows);

/// The surface after `rounds` rounds of Loop, and the control points of the patch of every face, in enclosures. Throws Rejected
/// if a face has two irregular vertices, Error{interrupted} when told to stop.
struct EnclosedPatches {
  std::shared_ptr<const Mesh> mesh;
  Points<Interval> points;
  std::vector<LoopPatch> patch;       // per face
  std::vector<Points<Interval>> net;  // per face
};
EnclosedPatches enclosed_patches(const LoopMesh& surface, int rounds, const std::atomic<bool>* stop = nullptr);
/// Steps of all valences that occur, 6 included.
std::map<int, PatchStep<Interval>> enclosed_steps(const Mesh& mesh);

}  // namespace udcp
