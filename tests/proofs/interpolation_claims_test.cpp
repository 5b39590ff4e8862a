// Theorems on interpolation: expected verdicts, false claims, changed certificates; the exact numbers of tangents.
#include "proofs/interpolation_claims.h"

#include <doctest/doctest.h>

#include "operators/methods/interpolation/interpolation.h"
#include "operators/schemes.h"
#include "operators/shapes.h"
#include "proofs/checkers.h"
#include "tests/oracle/inputs.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

Rational ratio(int p, int q) { return Rational(p) / Rational(q); }

/// The cube with tilted rational normals, or its displaced sister, whose valence 3 makes A = (1 + sqrt(17))/2.
ExactInterpolation hexahedron(bool displaced = false) {
  ExactInterpolation what;
  what.cage = cube<Rational>();
  if (displaced) {
    what.cage.points(7, 0) += ratio(1, 2);
    what.cage.points(0, 1) += ratio(1, 4);
  }
  what.normals = what.cage.points;
  for (int v = 0; v < 8; ++v) what.normals(v, 0) += ratio(2, 5) * what.cage.points(v, 1);
  return what;
}

/// A closed mesh with valences 3, 4 and 5 (and faces that are no quads, if wanted): prism of n with pyramids on both ends.
ExactInterpolation capped_prism(int n) {
  Faces faces;
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    faces.push_back({i, j, n + j, n + i});
    faces.push_back({j, i, 2 * n});
    faces.push_back({n + i, n + j, 2 * n + 1});
  }
  ExactInterpolation what;
  what.cage.mesh = std::make_shared<const Mesh>(make_mesh(2 * n + 2, faces));
  what.cage.points = Points<Rational>::Zero(2 * n + 2, 3);
  for (int i = 0; i < 2 * n; ++i) {  // rational points near a circle
    what.cage.points(i, 0) = Rational::from_double(std::round(64 * std::cos(2 * std::acos(-1.0) * i / n))) / Rational(32);
    what.cage.points(i, 1) = Rational::from_double(std::round(64 * std::sin(2 * std::acos(-1.0) * i / n))) / Rational(32);
    what.cage.points(i, 2) = i < n ? Rational(-1) : Rational(1);
  }
  what.cage.points(2 * n, 2) = Rational(-2);
  what.cage.points(2 * n + 1, 2) = Rational(2);
  what.normals = what.cage.points;
  return what;
}

Json part_of(const Result& result, const std::string& kind) {
  const Json& certificate = *result.certificate;
  if (certificate["kind"] == kind) return certificate["data"];
  for (const Json& part : certificate["data"]["parts"])
    if (part["kind"] == kind) return part["data"];
  return nullptr;
}

/// Every leaf of the data changed in turn: no change may leave a certificate of the same statement.
void check_changes(const Json& data, const std::string& kind, std::string (*check)(const Json&, StopFlag)) {
  const std::string statement = check(data, nullptr);
  const auto survives = [&](const Json& changed) {
    try {
      return check(changed, nullptr) == statement;
    } catch (const std::exception&) {
      return false;
    }
  };
  CAPTURE(kind);
  int changes = 0;
  const Json flat = data.flatten();
  for (const auto& [pointer, leaf] : flat.items()) {
    const Json::json_pointer where(pointer);
    const std::string place = pointer;
    CAPTURE(place);
    std::vector<Json> others{nullptr, Json("7"), Json(12345)};
    if (leaf.is_number()) others.emplace_back(leaf.get<int>() + 1);
    if (leaf.is_string()) {
      const auto text = leaf.get<std::string>();
      for (std::size_t k = 0; k < std::min<std::size_t>(text.size(), 4); ++k) {
        std::string other = text;
        other[k] = other[k] == '1' ? '0' : '1';
        others.emplace_back(other);
      }
      others.emplace_back(text + "0");
    }
    for (const Json& other : others) {
      if (other == leaf) continue;
      Json changed = data;
      changed[where] = other;
      ++changes;
      CHECK_FALSE(survives(changed));
    }
  }
  Json more = data;
  more["more"] = 1;
  CHECK_FALSE(survives(more));
  CHECK(changes > 10);
}

}  // namespace

TEST_SUITE_BEGIN("proofs");

TEST_CASE("numbers a + b A satisfy the equation of A and decide their sign") {
  for (int n = 3; n <= 20; ++n) {
    CAPTURE(n);
    const TangentNumber a = TangentNumber::weight(n), c(Algebraic::cosine(Rational(2) / Rational(n)));
    const double theta = 2 * std::acos(-1.0) / n;
    CHECK(a.to_double() == doctest::Approx(1 + std::cos(theta) + std::cos(theta / 2) * std::sqrt(2 * (9 + std::cos(theta)))));
    const TangentNumber equation =
        a * a - TangentNumber(2) * (TangentNumber(1) + c) * a - TangentNumber(8) * (TangentNumber(1) + c);
    CHECK(equation.is_zero());
    CHECK(equation.sign() == 0);
    CHECK(a.sign() == 1);
    CHECK((a * a.inverse() - TangentNumber(1)).is_zero());
    CHECK((TangentNumber(Rational::from_double(a.to_double() * (1 + 1e-14))) - a).sign() == 1);
    CHECK((TangentNumber(Rational::from_double(a.to_double() * (1 - 1e-14))) - a).sign() == -1);
  }
  // where A lies in the field of c, different pairs are one number
  const TangentNumber four = TangentNumber::weight(4) - TangentNumber(4);
  CHECK(four.is_zero());
  CHECK(four.sign() == 0);
  const TangentNumber root = TangentNumber(2) * TangentNumber::weight(3) - TangentNumber(1);
  CHECK((root * root - TangentNumber(17)).is_zero());
  CHECK((TangentNumber::weight(4) + TangentNumber(2)).sign() == 1);  // A = -2 is the conjugate
}

TEST_CASE("the weights of limits and tangents are exact eigenvectors of the running word") {
  for (int n = 3; n <= 16; ++n) CHECK(are_masks_eigenvectors(n));
  CHECK(are_masks_eigenvectors(40));
}

TEST_CASE("exact rings agree with the running ones") {
  for (const ExactInterpolation& what : {hexahedron(true), capped_prism(5)}) {
    PointOptions local;
    local.step = PointStep::local;
    const Surface<Rational> exact = run(schemes::catmull_clark(), interpolate_points(what.cage, local), 1);
    const Surface<double> fine = convert<double>(exact);
    RingMasks masks;
    Fan fan;
    for (int v = 0; v < what.cage.mesh->vertices(); ++v) {
      const ExactRing ring = exact_ring(exact, v, what.normals.row(v));
      collect_fan(*fine.mesh, v, fan);
      const RingTangents t = tangents_at(fine.points, v, fan, *masks.weights(fan));
      Eigen::RowVector3d n;
      for (int c = 0; c < 3; ++c) n[c] = what.normals(v, c).to_double();
      const double sine = std::sin(2 * std::acos(-1.0) / ring.valence);
      CHECK(ring.side.to_double() * sine == doctest::Approx(normal_of(t).dot(n)));
      double first = 0, second = 0;
      for (int j = 0; j < ring.valence; ++j) {
        first += ring.heights[Mesh::i(j)].to_double() * std::cos(2 * std::acos(-1.0) * j / ring.valence);
        second += ring.heights[Mesh::i(j)].to_double() * std::sin(2 * std::acos(-1.0) * j / ring.valence);
      }
      CHECK(first == doctest::Approx(t.first.dot(n)));
      CHECK(second == doctest::Approx(t.second.dot(n)));
      for (const bool tied : {false, true}) {
        const CorrectedRing after = corrected(ring, tied);
        CHECK(after.keeps_limit);
        CHECK(is_flat(after.heights));
        const RingTangents change = change_to_plane(t, n);
        const Points<double> rows = ring_corrections(fan, *masks.weights(fan), change, tied ? Spread::tied : Spread::free);
        const double weight = TangentNumber::weight(ring.valence).to_double();
        const auto k = static_cast<Eigen::Index>(ring.valence);
        for (int j = 0; j < ring.valence; ++j) {  // the same corrections, seen across the normal
          const double moved =
              (weight * rows.row(j) + rows.row(k + j) + rows.row(k + (j + ring.valence - 1) % ring.valence)).dot(n);
          CHECK(after.heights[Mesh::i(j)].to_double() - ring.heights[Mesh::i(j)].to_double() == doctest::Approx(moved));
        }
      }
    }
  }
}

TEST_CASE("exact interpolation is proved for exact meshes and normals") {
  for (ExactInterpolation what : {hexahedron(), hexahedron(true), capped_prism(5), capped_prism(3)}) {
    for (const bool global : {false, true}) {
      what.global = global;
      what.lambda = ratio(7, 10);
      what.tied = global;
      const Result result = prove_interpolation(what);
      CAPTURE(result.reason);
      CHECK(result.verdict == Verdict::proved);
      REQUIRE(result.certificate.has_value());
      CHECK(verify(*result.certificate).accepted);
      CHECK(result.claim.find("C^1") != std::string::npos);
      CHECK(result.claim.find("passes exactly through every vertex") != std::string::npos);
    }
  }
}

TEST_CASE("normals on the wrong side refute that they are interpolated") {
  ExactInterpolation what = hexahedron();
  what.normals.row(6) = -what.normals.row(6);
  const Result opposite = prove_interpolation(what);
  CHECK(opposite.verdict == Verdict::refuted);
  CHECK(opposite.witness["vertex"] == 6);
  REQUIRE(opposite.certificate.has_value());
  CHECK(verify(*opposite.certificate).accepted);
  what = hexahedron();
  what.normals = what.cage.points;
  what.normals(7, 0) = Rational(1);  // (1, -1, 0) is exactly tangent at (1, 1, 1): by symmetry the normal there is (1, 1, 1)
  what.normals(7, 1) = Rational(-1);
  what.normals(7, 2) = Rational(0);
  const Result tangent = prove_interpolation(what);
  CHECK(tangent.verdict == Verdict::refuted);
  CHECK(tangent.witness["vertex"] == 7);
  what.normals(7, 2) = ratio(1, 1'000'000'000);
  CHECK(prove_interpolation(what).verdict == Verdict::proved);
  Json data = part_of(tangent, "interpolation-reversed");
  data["vertex"] = 3;
  CHECK_THROWS_AS((void)check_interpolation_reversed(data), Rejected);
  data.erase("vertex");
  CHECK_THROWS_AS((void)check_interpolation(data), Rejected);
}

TEST_CASE("what the theorem of interpolation does not cover is undecided with the reason") {
  ExactInterpolation what = hexahedron();
  what.normals.row(2).setZero();
  CHECK(prove_interpolation(what).reason == "the normal at vertex 2 is zero");
  what = hexahedron();
  what.global = true;
  what.lambda = ratio(7, 20);
  CHECK(prove_interpolation(what).reason == "lambda = 7/20 is outside (7/20, 1]");
  what.cage = grid<Rational>(2, 2);
  what.normals = Points<Rational>::Constant(9, 3, Rational(1));
  CHECK(prove_interpolation(what).reason == "vertex 0 lies on the boundary; the theorem is for closed meshes");
  CHECK(prove_interpolation(what).verdict == Verdict::undecided);
  what = hexahedron();
  const std::atomic<bool> stop{true};
  SearchLimits limits;
  limits.stop = &stop;
  CHECK_THROWS_AS((void)prove_interpolation(what, limits), Error);
  limits.stop = nullptr;
  const Json data = part_of(prove_interpolation(what), "interpolation");
  CHECK_THROWS_AS((void)check_interpolation(data, &stop), Error);
  limits.nodes = 3;
  CHECK(prove_interpolation(what, limits).verdict == Verdict::undecided);
}

TEST_CASE("the range of lambda is proved per valence and refuted below it on two-colourable meshes") {
  const Result range = prove_lambda_range({8, 3, 4, 4});
  CHECK(range.verdict == Verdict::proved);
  CHECK(range.claim.find("valence 3, 4, 8 only") != std::string::npos);
  CHECK(range.details["bound at valence 4"] == "(80*lambda - 28)/117");
  CHECK(prove_lambda_range({2, 3}).verdict == Verdict::undecided);
  CHECK(prove_lambda_range({3, 100000}).verdict == Verdict::undecided);
  const Mesh box = *cube<Rational>().mesh, odd = *torus<double>(5, 3, 2, 1).mesh, even = *torus<double>(6, 4, 2, 1).mesh;
  CHECK(prove_iteration_converges(box, ratio(7, 10)).verdict == Verdict::proved);
  CHECK(prove_iteration_converges(odd, ratio(351, 1000)).verdict == Verdict::proved);
  for (const Mesh& mesh : {box, even}) {
    for (const Rational& lambda : {ratio(7, 20), ratio(3, 10), Rational(-5)}) {
      const Result refuted = prove_iteration_converges(mesh, lambda);
      CHECK(refuted.verdict == Verdict::refuted);
      REQUIRE(refuted.certificate.has_value());
      CHECK(verify(*refuted.certificate).accepted);
    }
  }
  CHECK(part_of(prove_iteration_converges(box, ratio(7, 20)), "interpolation-checkerboard")["quotient"] == "0");
  // n (20 lambda - 7)/(13 (n + 5)) at n = 3, lambda = 3/10
  CHECK(part_of(prove_iteration_converges(box, ratio(3, 10)), "interpolation-checkerboard")["quotient"] == "-3/104");
  CHECK(prove_iteration_converges(odd, ratio(3, 10)).verdict == Verdict::undecided);
  CHECK(prove_iteration_converges(box, Rational(2)).verdict == Verdict::undecided);
  CHECK(prove_iteration_converges(prism(5), ratio(7, 10)).verdict == Verdict::undecided);
  CHECK(prove_iteration_converges(*grid<double>(3, 3).mesh, ratio(7, 10)).verdict == Verdict::undecided);
}

TEST_CASE("certificates of interpolation with anything changed are rejected") {
  ExactInterpolation what = hexahedron(true);
  check_changes(part_of(prove_interpolation(what), "interpolation"), "local", check_interpolation);
  what.global = true;
  what.lambda = ratio(2, 5);
  check_changes(part_of(prove_interpolation(what), "interpolation"), "global", check_interpolation);
  what.normals.row(1) = -what.normals.row(1);
  check_changes(part_of(prove_interpolation(what), "interpolation-reversed"), "reversed", check_interpolation_reversed);
  check_changes(part_of(prove_lambda_range({3, 4, 6}), "interpolation-threshold"), "threshold", check_interpolation_threshold);
  check_changes(part_of(prove_iteration_converges(*cube<Rational>().mesh, ratio(3, 10)), "interpolation-checkerboard"),
                "checkerboard", check_interpolation_checkerboard);
}

TEST_CASE("control points of another lambda do not serve") {
  ExactInterpolation what = hexahedron(true);
  what.global = true;
  what.lambda = ratio(2, 5);
  Json data = part_of(prove_interpolation(what), "interpolation");
  what.lambda = ratio(7, 10);
  const Json other = part_of(prove_interpolation(what), "interpolation");
  CHECK(check_interpolation(data) != check_interpolation(other));
  data["control"] = other["control"];
  CHECK_THROWS_AS((void)check_interpolation(data), Rejected);
  data["lambda"] = "7/10";
  CHECK(check_interpolation(data) == check_interpolation(other));
  Json colours = part_of(prove_iteration_converges(*cube<Rational>().mesh, ratio(3, 10)), "interpolation-checkerboard");
  colours["lambda"] = "7/10";
  CHECK_THROWS_AS((void)check_interpolation_checkerboard(colours), Rejected);
}

TEST_SUITE_END();
