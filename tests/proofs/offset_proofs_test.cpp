// Theorems on offsets of Loop surfaces: what is proved, what is refuted, what must not come out, and certificates under attack.
#include "proofs/offset_proofs.h"

#include <doctest/doctest.h>

#include <cmath>

#include "operators/methods/offset/offset.h"
#include "operators/shapes.h"
#include "proofs/offset_statements.h"
#include "tests/oracle/leaves.h"
#include "tests/oracle/refusal.h"

namespace udcp {
namespace {

OffsetResult offset_by(const Surface<double>& mesh, double distance) {
  OffsetOptions options;
  options.distance = distance;
  return offset(mesh, options);
}

Rational exact(double x) { return Rational::from_double(x); }
const Rational quarter = exact(0.25);

/// A ring of `m` times `n` vertices with outer and inner radius, by the parametrisation of a torus.
Surface<double> torus_mesh(int m, int n, double outer, double inner) { return triangulate(torus<double>(m, n, outer, inner)); }

Json resealed(const Json& certificate, const Json& data) {
  return seal(certificate["kind"].get<std::string>(), certificate["statement"].get<std::string>(), data);
}

/// Every `every`-th leaf of the data changed in turn: none of the changed certificates may be accepted.
void attack(const Json& certificate, std::size_t every = 1, const std::string& leave_out = "none") {
  const std::vector<std::string> leaves = oracle::leaves(certificate["data"]);
  for (std::size_t k = 0; k < leaves.size(); k += every) {
    if (leaves[k].find(leave_out) != std::string::npos) continue;
    for (const Json& other : oracle::other_values(certificate["data"][Json::json_pointer(leaves[k])])) {
      Json data = certificate["data"];
      data[Json::json_pointer(leaves[k])] = other;
      CAPTURE(leaves[k]);
      CAPTURE(other.dump());
      CHECK(!verify(resealed(certificate, data)).accepted);
    }
  }
}

TEST_SUITE("proofs") {
  TEST_CASE("the edge iteration contracts by 9/13 at valence 3 and by 93/161 at valence 4") {
    for (const auto& [valence, bound] : {std::pair{3, "9/13"}, {4, "93/161"}, {6, "3/7"}}) {
      const Result result = prove_offset_contraction(valence, LocalSet::star);
      CAPTURE(result.reason);
      CHECK(result.verdict == Verdict::proved);
      CHECK((*result.certificate)["data"]["bound"] == bound);
    }
    for (int n = 5; n <= 12; ++n) {
      CAPTURE(n);
      const Result result = prove_offset_contraction(n, LocalSet::pair);
      CHECK(result.verdict == Verdict::proved);
      // (6N - 5)/(6w - 1), w = 24 N/(40 - q), q = (3 + 2 cos(2 pi/N))^2
      const Algebraic root = Algebraic(3) + Algebraic(2) * Algebraic::cosine(Rational(2) / Rational(n));
      const Algebraic w = Algebraic(24 * n) / (Algebraic(40) - root * root);
      CHECK((*result.certificate)["data"]["bound"] == to_json(Algebraic(6 * n - 5) / (Algebraic(6) * w - Algebraic(1))));
      // 3 N/(8 w - N)
      CHECK(contraction_bound(n, LocalSet::star) == Algebraic(3 * n) / (Algebraic(8) * w - Algebraic(n)));
    }
    CHECK(prove_offset_contraction(3, LocalSet::star).claim ==
          "the edge iteration for offsets of Loop surfaces, at vertices of valence 3 with their star of regular neighbours, has "
          "coefficients whose moduli sum to less than 1, at most 9/13");
  }

  TEST_CASE("pairs do not contract at valences 3 and 4") {
    for (const int n : {3, 4}) {
      const Result result = prove_offset_contraction(n, LocalSet::pair);
      CHECK(result.verdict == Verdict::refuted);
      CHECK(!result.certificate);
      const Json forged = seal("offset-contraction", result.claim, result.witness);
      CHECK(verify(forged).reason == "bound is not below 1");
    }
    CHECK(prove_offset_contraction(3, LocalSet::pair).witness["bound"] == "13/11");
    CHECK(oracle::refusal([] { (void)prove_offset_contraction(2, LocalSet::star); }) ==
          "E_DOMAIN: contraction is computed for valences 3 to 24, not 2");
  }

  TEST_CASE("the system is positive definite at every valence up to 30") {
    for (int n = 3; n <= 30; ++n) {
      const Result result = prove_offset_definite(n);
      CAPTURE(result.reason);
      CHECK(result.verdict == Verdict::proved);
      if (n == 3) CHECK((*result.certificate)["data"]["bound"] == "1/10");
      if (n == 4) CHECK((*result.certificate)["data"]["bound"] == "17/110");
      if (n == 6) CHECK((*result.certificate)["data"]["bound"] == "1/4");
    }
    const Result all = all_of({prove_offset_definite(5), prove_offset_definite(6)});
    CHECK(all.verdict == Verdict::proved);
    CHECK(oracle::refusal([] { (void)prove_offset_definite(201); }) == "E_DOMAIN: valences are 3 to 200 here, not 201");
  }

  TEST_CASE("every number of certificates on the system is checked") {
    attack(*prove_offset_contraction(5, LocalSet::pair).certificate);
    attack(*prove_offset_contraction(4, LocalSet::star).certificate);
    attack(*prove_offset_definite(7).certificate);
  }

  TEST_CASE("errors of offsets are bounded by proof close to the samples") {
    const OffsetResult octa = offset_by(octahedron<double>(), 0.25);
    const Result lengths = prove_offset_error(octa.base, octa.d, quarter, false);
    CAPTURE(lengths.reason);
    CHECK(lengths.verdict == Verdict::proved);
    const double bound = rational_from((*lengths.certificate)["data"]["bound"], "bound").to_double();
    CHECK(bound >= octa.errors.eps);
    CHECK(bound <= 1.45 * octa.errors.eps);
    const OffsetResult ring = offset_by(torus_mesh(9, 6, 2.0, 0.75), 0.25);
    const Result vectors = prove_offset_error(ring.base, ring.d, quarter, true, exact(3 * ring.errors.full));
    CAPTURE(vectors.reason);
    CHECK(vectors.verdict == Verdict::proved);
  }

  TEST_CASE("a bound below an error that occurs is not proved") {
    const OffsetResult result = offset_by(octahedron<double>(), -0.125);
    SearchLimits limits;
    limits.seconds = 0.2;
    for (const bool full : {true, false}) {
      const double error = full ? result.errors.full : result.errors.eps;
      CHECK(prove_offset_error(result.base, result.d, exact(-0.125), full, exact(0.99 * error), limits).verdict ==
            Verdict::undecided);
      const Result above = prove_offset_error(result.base, result.d, exact(-0.125), full, exact(3 * error));
      CAPTURE(above.reason);
      REQUIRE(above.verdict == Verdict::proved);
      Json data = (*above.certificate)["data"];
      data["bound"] = to_json(exact(0.99 * error));
      CHECK(verify(resealed(*above.certificate, data)).reason == "the bound does not hold on a cell");
      data = (*above.certificate)["data"];
      data["distance"] = to_json(exact(full ? 0.125 : 0.25));
      CHECK(!verify(resealed(*above.certificate, data)).accepted);
    }
  }

  TEST_CASE("every number of a certificate of an error is checked") {
    const OffsetResult result = offset_by(tetrahedron<double>(), 0.25);
    const Result proof = prove_offset_error(result.base, result.d, quarter, false, exact(0.2));
    CAPTURE(proof.reason);
    REQUIRE(proof.verdict == Verdict::proved);
    attack(*proof.certificate);
  }

  TEST_CASE("convex surfaces and tori are proved not to meet themselves") {
    for (const Surface<double>& mesh : {torus_mesh(8, 5, 2.0, 0.75), tetrahedron<double>()}) {
      const Result proof = prove_embedded(mesh);
      CAPTURE(mesh.mesh->vertices());
      CAPTURE(proof.reason);
      CHECK(proof.verdict == Verdict::proved);
      CHECK(proof.claim.find("does not meet itself") != std::string::npos);
    }
  }

  TEST_CASE("a surface that meets itself is not proved embedded") {
    // A tube thicker than its ring: the inner sides pass through one another.
    Surface<double> thick = torus_mesh(9, 6, 1.0, 1.6);
    SearchLimits limits;
    limits.seconds = 1;
    CHECK(prove_embedded(thick, limits).verdict == Verdict::undecided);
    Surface<double> inside_out = icosahedron<double>();
    inside_out.points.row(0) *= -1.5;  // a spike pulled through to the other side
    CHECK(prove_embedded(inside_out, limits).verdict == Verdict::undecided);
    const Surface<double> good = torus_mesh(9, 6, 2.0, 0.75);
    const Result proof = prove_embedded(good);
    REQUIRE(proof.verdict == Verdict::proved);
    Json data = (*proof.certificate)["data"];
    data["points"] = exact_rows_to_json(exact_rows(thick.points));
    CHECK(!verify(resealed(*proof.certificate, data)).accepted);
    // Another axis, or another plane, may prove the same.
    attack(*proof.certificate, 211, "/axes");
    data = (*proof.certificate)["data"];
    data["axes"][5] = {0, 0, 0};
    CHECK(verify(resealed(*proof.certificate, data)).reason == "the surface around vertex 5 is not seen to be a graph");
  }

  TEST_CASE("searches stop when they are told to") {
    std::atomic<bool> stop = true;
    SearchLimits limits;
    limits.stop = &stop;
    CHECK(oracle::refusal([&] { (void)prove_embedded(icosahedron<double>(), limits); }) == "E_INTERRUPTED: interrupted");
    limits.stop = nullptr;
    limits.nodes = 3;
    CHECK(prove_embedded(icosahedron<double>(), limits).verdict == Verdict::undecided);
    CHECK(oracle::refusal([] { (void)prove_embedded(cube<double>()); }).substr(0, 15) == "E_NOT_TRIANGLES");
    CHECK(prove_embedded(triangulate(grid<double>(2, 2))).reason == "the mesh must be closed");
  }
}

}  // namespace
}  // namespace udcp
