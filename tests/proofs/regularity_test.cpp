// Regularity of patches: nets, tests T1 to T4 and the adaptive decision, against exact expected values and identities.
#include "proofs/regularity/global_test.h"
#include "proofs/regularity/half_space.h"
#include "tests/proofs/regularity_meshes.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

Rational rational(const Json& text) { return Rational::parse(text.get<std::string>()); }

Vector3 vector_from(const Json& list) {
  Vector3 result{};
  for (std::size_t c = 0; c < list.size(); ++c) result[c] = rational(list[c]);
  return result;
}

const std::vector<std::pair<std::string, RegularityMode>> modes = {{"interior", RegularityMode::interior},
                                                                   {"bspline", RegularityMode::bspline}};

AdaptiveResult decide(const QuadMesh& mesh, RegularityMode mode, RegularityTest test, int depth) {
  const Patches p = patches(mesh, mode);
  AdaptiveOptions options;
  options.test = test;
  options.depth = depth;
  options.planar = mesh.is_planar();
  return decide_patches(p.nets, p.groups, options);
}

std::string status_name(const AdaptiveResult& result) {
  switch (result.status) {
    case AdaptiveResult::Status::regular:
      return "regular";
    case AdaptiveResult::Status::undecided:
      return "undecided";
    default:
      return "irregular";
  }
}

void check_adaptive(const AdaptiveResult& result, const Json& expected, const std::vector<int>& faces) {
  CHECK(status_name(result) == expected["status"]);
  CHECK(result.depth == expected["depth"]);
  if (expected.contains("kind")) CHECK((result.status == AdaptiveResult::Status::zero ? "zero" : "sign") == expected["kind"]);
  if (expected.contains("per_level")) {
    Json levels = Json::array();
    for (const auto& [tested, passed] : result.per_level) {
      Json level = Json::array();
      level.push_back(tested);
      level.push_back(passed);
      levels.push_back(std::move(level));
    }
    CHECK(levels == expected["per_level"]);
  }
  if (!expected.contains("witness")) return;
  const Json& points = expected["witness"];
  REQUIRE(result.witness.size() == points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    CHECK(faces[static_cast<std::size_t>(result.witness[k].patch)] == points[k][0]);
    CHECK(result.witness[k].u == rational(points[k][1]));
    CHECK(result.witness[k].v == rational(points[k][2]));
  }
}

void check_leaves(const AdaptiveResult& result, const std::vector<BicubicNet>& nets, RegularityTest test, bool planar) {
  std::vector<Rational> covered(nets.size(), Rational(0));
  for (const RegularLeaf& leaf : result.leaves) {
    const auto k = static_cast<std::size_t>(leaf.patch);
    CHECK(is_witness(leaf.witness, descendant(nets[k], leaf.path), test, planar));
    covered[k] += pow(Rational(1) / Rational(4), static_cast<int>(leaf.path.size()));
  }
  if (result.status == AdaptiveResult::Status::regular)
    for (const Rational& area : covered) CHECK(area == Rational(1));
}

}  // namespace

TEST_CASE("half spaces are found exactly when there is one") {
  for (const Json& set : expected_regularity()["predicates"]) {
    CAPTURE(set["name"].get<std::string>());
    std::vector<Vector3> vectors;
    for (const Json& w : set["vectors"]) vectors.push_back(primitive(vector_from(w)));
    const std::optional<Vector3> normal = half_space(vectors);
    CHECK(normal.has_value() == set["in_open_halfspace"].get<bool>());
    if (normal) CHECK(is_positive_on(*normal, vectors));
  }
}

TEST_CASE("nearly opposite vectors too close for floating point are told apart") {
  const Rational big = pow(Rational(10), 40);
  const std::vector<Vector3> apart = {{big, 1, 0}, {-big, 1, 0}, {0, 1, big}, {0, 1, -big}};
  const std::optional<Vector3> normal = half_space(apart);
  REQUIRE(normal);
  CHECK(is_positive_on(*normal, apart));
  CHECK_FALSE(half_space(std::vector<Vector3>{{big, 1, 0}, {-big, -1, 0}}));
  CHECK_FALSE(half_space(std::vector<Vector3>{{big, 1, 0}, {-big, 1, 0}, {0, -big, 1}, {0, -big, -1}}));
}

TEST_CASE("classes tests and adaptive decisions of the meshes are the expected ones") {
  for (const auto& [key, expected] : expected_regularity()["meshes"].items()) {
    const std::string& name = key;
    CAPTURE(name);
    const QuadMesh mesh(regularity_mesh(name));
    CHECK(mesh.mesh().vertices() == expected["vertices"]);
    CHECK((mesh.is_planar() ? 2 : 3) == expected["dim"]);
    std::map<std::string, int> classes;
    for (int v = 0; v < mesh.mesh().vertices(); ++v) ++classes[to_string(mesh.class_of(v))];
    CHECK(Json(classes) == Json(expected["vertex_classes"].get<std::map<std::string, int>>()));
    CHECK(to_string(test_globally(mesh).status) == expected["T1"]);
    CHECK(is_rectangle(mesh) == expected["rectangular"].get<bool>());
    for (const auto& mode : modes) {
      CAPTURE(mode.first);
      const Json& e = expected[mode.first];
      CHECK(count(mesh, mode.second, FaceKind::patch) == e["patches"]);
      CHECK(count(mesh, mode.second, FaceKind::excluded) == e["excluded_faces"]);
      CHECK(count(mesh, mode.second, FaceKind::outside) == e["outside_faces"]);
      const Patches p = patches(mesh, mode.second);
      for (const RegularityTest test : {RegularityTest::t2, RegularityTest::t3, RegularityTest::t4}) {
        CAPTURE(to_string(test));
        const auto failing = std::count_if(p.nets.begin(), p.nets.end(),
                                           [&](const BicubicNet& net) { return !find_witness(net, test, mesh.is_planar()); });
        CHECK(failing == e[to_string(test) + "_failing"]);
        const AdaptiveResult result = decide(mesh, mode.second, test, 6);
        check_adaptive(result, e["adaptive_" + to_string(test)], p.faces);
        check_leaves(result, p.nets, test, mesh.is_planar());
      }
    }
  }
}

TEST_CASE("decisions after exact refinement are the expected ones") {
  for (const auto& [key, expected] : expected_regularity()["meshes"].items()) {
    const std::string& name = key;
    if (!expected.contains("after_cc_steps")) continue;
    for (const Json& e : expected["after_cc_steps"]) {
      CAPTURE(name);
      CAPTURE(e.dump());
      const QuadMesh mesh(refined(regularity_mesh(name), e["steps"]));
      CHECK(to_string(test_globally(mesh).status) == e["T1"]);
      CHECK(count(mesh, RegularityMode::bspline, FaceKind::patch) == e["patches"]);
      CHECK(count(mesh, RegularityMode::bspline, FaceKind::excluded) == e["excluded_faces"]);
      check_adaptive(decide(mesh, RegularityMode::bspline, RegularityTest::t2, 4), e["adaptive_T2_depth4"],
                     patches(mesh, RegularityMode::bspline).faces);
    }
  }
}

TEST_CASE("nets corners and normal coefficients of patches are the expected ones") {
  for (const auto& [key, list] : expected_regularity()["patches"].items()) {
    const std::string& name = key;
    const QuadMesh mesh(regularity_mesh(name));
    for (const Json& e : list) {
      CAPTURE(name);
      const int face = e["face"];
      CAPTURE(face);
      const BicubicNet net = mesh.net(face);
      const Vector3 first = vector_from(e["net"][1][2]) - vector_from(e["net"][1][1]);
      const Vector3 ours = net.at(1, 2) - net.at(1, 1);
      const Rational scale = ours[0] / first[0];  // to integers
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
          CHECK(net.at(i, j) == scale * vector_from(e["net"][static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]));
      for (std::size_t side = 0; side < 4; ++side) CHECK(net.flagged[side] == e["flags_bottom_right_top_left"][side].get<bool>());
      for (const Json& c : e["corners"]) {
        const CornerValues values = corner(net, c["v"], c["u"]);
        CHECK(values.point == Rational(36) * scale * vector_from(c["S"]));
        CHECK(values.du == Rational(12) * scale * vector_from(c["Su"]));
        CHECK(values.dv == Rational(12) * scale * vector_from(c["Sv"]));
      }
      const std::array<Vector3, 36> normals = normal_net(net);
      const Rational factor = scale * scale * Rational(14400);
      for (std::size_t l = 0; l < 6; ++l) {
        for (std::size_t k = 0; k < 6; ++k) {
          const Json& w = e["bernstein55_rows_v"][l][k];
          if (mesh.is_planar())
            CHECK(normals[6 * l + k][2] == factor * rational(w));
          else
            CHECK(normals[6 * l + k] == factor * vector_from(w));
        }
      }
    }
  }
}

TEST_CASE("quarters of a net are the nets of the refined mesh") {
  for (const std::string name : {"grid_perturbed", "bump3d", "horseshoe"}) {
    CAPTURE(name);
    const Surface<Rational> coarse = regularity_mesh(name);
    const QuadMesh mesh(coarse), finer(refined(coarse, 1));
    for (int f = 0; f < mesh.mesh().faces(); ++f) {
      if (mesh.kind_of(f, RegularityMode::bspline) != FaceKind::patch) continue;
      // The quarter that keeps the first corner, its fine face found by that vertex, which keeps its number.
      const int first = mesh.mesh().corners(f)[0];
      bool found = false;
      for (int g = 4 * f; g < 4 * f + 4; ++g) {
        if (finer.mesh().corners(g)[0] != first) continue;
        found = true;
        const BicubicNet quarter = child(mesh.net(f), 0), net = finer.net(g);
        const Vector3 a = quarter.at(1, 2) - quarter.at(1, 1), b = net.at(1, 2) - net.at(1, 1);
        const std::size_t c = a[0].is_zero() ? 1 : 0;
        const Rational scale = b[c] / a[c];
        for (int i = 0; i < 4; ++i)
          for (int j = 0; j < 4; ++j) CHECK(net.at(i, j) - net.at(1, 1) == scale * (quarter.at(i, j) - quarter.at(1, 1)));
        CHECK(net.flagged == quarter.flagged);
      }
      CHECK(found);
    }
  }
}

TEST_CASE("each test implies the next on random nets and every gap occurs") {
  std::mt19937 random(20'24);
  int gaps_23 = 0, gaps_34 = 0;
  for (int round = 0; round < 400; ++round) {
    const bool planar = round % 2 == 0;
    const BicubicNet net = random_net(random, planar, 2 + round % 9);
    const auto passes = [&](RegularityTest test) { return find_witness(net, test, planar).has_value(); };
    const bool t2 = passes(RegularityTest::t2), t3 = passes(RegularityTest::t3), t4 = passes(RegularityTest::t4);
    CHECK((!t2 || t3));
    CHECK((!t3 || t4));
    gaps_23 += t3 && !t2 ? 1 : 0;
    gaps_34 += t4 && !t3 ? 1 : 0;
  }
  CHECK(gaps_23 > 0);
  CHECK(gaps_34 > 0);
}

TEST_CASE("signs of determinants in the plane agree with separation by two half planes") {
  std::mt19937 random(7);
  int both = 0;
  for (int round = 0; round < 300; ++round) {
    const BicubicNet net = random_net(random, true, 2 + round % 9);
    const std::optional<ConeVectors> cones = cone_vectors(net, RegularityTest::t2);
    REQUIRE(cones);
    const bool separated = separating_pair(*cones).has_value();
    CHECK(find_witness(net, RegularityTest::t2, true).has_value() == separated);
    both += separated ? 1 : 0;
  }
  CHECK(both > 20);
  CHECK(both < 280);
}

TEST_CASE("corners of the Bezier net are the corners of the patch") {
  std::mt19937 random(11);
  for (int round = 0; round < 20; ++round) {
    const BicubicNet net = random_net(random, false, 9), b = bezier(net);
    for (int r = 0; r < 2; ++r) {
      for (int c = 0; c < 2; ++c) {
        CHECK(b.at(3 * r, 3 * c) == corner(net, r, c).point);
        const Vector3 du = b.at(3 * r, c == 0 ? 1 : 3) - b.at(3 * r, c == 0 ? 0 : 2);
        CHECK(du == corner(net, r, c).du);  // both 12 S_u: three differences over 36
      }
    }
  }
}

TEST_CASE("a search without nodes is undecided and names every patch") {
  const QuadMesh mesh(regularity_mesh("grid_regular"));
  const Patches p = patches(mesh, RegularityMode::bspline);
  AdaptiveOptions options;
  options.planar = true;
  options.limits.nodes = 10;
  const AdaptiveResult result = decide_patches(p.nets, p.groups, options);
  CHECK(result.status == AdaptiveResult::Status::undecided);
  CHECK(result.out_of_budget);
  CHECK(result.open.size() == p.nets.size() - 10);
}
