// Cones and differences: verdicts and numbers against the table of meshes, identities of angles, and pictures as XML.
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>

#include "files/geometry_file.h"
#include "interpreter/regularity_pictures.h"
#include "tests/interpreter/room.h"

namespace {

using namespace udcp;
using oracle::Room;

const Json& expected() {
  static const Json all = Json::parse(std::ifstream(UDCP_TEST_DATA "/regularity.json"));
  return all;
}

std::string path_of(const std::string& name) { return UDCP_TEST_DATA "/regularity/" + name + ".obj"; }
std::string loaded(const std::string& name) { return "load(\"" + path_of(name) + "\", exact = yes)"; }
Surface<Rational> mesh_of(const std::string& name) { return with_one_face_corners(load<Rational>(path_of(name))); }

ConeStudy study(const Surface<Rational>& surface, int steps, std::optional<int> face = std::nullopt) {
  return study_cones(surface, {RegularityMode::bspline, steps, face, {}});
}

std::string status_of(const ConeStudy& s, std::size_t level) {
  if (s.subject == ConeStudy::Subject::worst_patch) return "noframe";
  return s.levels[level].passed == s.levels[level].parts ? "pass" : "fail";
}

Surface<Rational> mapped(Surface<Rational> surface, const std::array<std::array<Rational, 3>, 3>& matrix, const Rational& shift) {
  const Points<Rational> old = surface.points;
  for (Eigen::Index v = 0; v < old.rows(); ++v) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      Rational sum = i < 2 ? shift : Rational(0);
      for (Eigen::Index j = 0; j < 3; ++j) sum += matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] * old(v, j);
      surface.points(v, i) = sum;
    }
  }
  return surface;
}

/// Names of the elements in order; empty if tags do not nest.
std::vector<std::string> elements(const std::string& xml) {
  std::vector<std::string> names, open;
  for (auto at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const auto end = xml.find('>', at);
    if (end == std::string::npos) return {};
    if (xml[at + 1] == '/') {
      if (open.empty() || open.back() != xml.substr(at + 2, end - at - 2)) return {};
      open.pop_back();
      continue;
    }
    names.push_back(xml.substr(at + 1, xml.find_first_of(" />", at + 1) - at - 1));
    if (xml[end - 1] != '/') open.push_back(names.back());
  }
  return open.empty() ? names : std::vector<std::string>{};
}

int occurrences(const std::string& text, const std::string& part) {
  int count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// The lines of the k-th path of an SVG text: how often it moves.
int lines_of_path(const std::string& svg, int k) {
  auto at = svg.find("<path");
  while (k-- > 0 && at != std::string::npos) at = svg.find("<path", at + 1);
  REQUIRE(at != std::string::npos);
  return occurrences(svg.substr(at, svg.find("/>", at) - at), "M");
}

Rational number(const Json& text) { return Rational::parse(text.get<std::string>()); }

bool same_numbers(const Json& a, const Json& b) {
  if (a.is_string() || b.is_string()) return number(a) == number(b);
  if (a.size() != b.size()) return false;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (!same_numbers(a[k], b[k])) return false;
  return true;
}

}  // namespace

TEST_SUITE_BEGIN("interpreter");

TEST_CASE("cones are separated for exactly the meshes of the table") {
  for (const auto& entry : expected()["meshes"].items()) {
    const std::string name = entry.key();
    const Json& row = entry.value();
    CAPTURE(name);
    const ConeStudy s = study(mesh_of(name), 0);
    CHECK(status_of(s, 0) == row["T1"].get<std::string>());
    CHECK(s.levels[0].patches == row["bspline"]["patches"].get<int>());
    CHECK(s.levels[0].excluded == row["bspline"]["excluded_faces"].get<int>());
    if (s.subject != ConeStudy::Subject::worst_patch) continue;
    CHECK(s.levels[0].parts - s.levels[0].passed == row["bspline"]["T2_failing"].get<int>());
  }
}

TEST_CASE("cones after exact steps are those of the table") {
  for (const auto& entry : expected()["meshes"].items()) {
    const std::string name = entry.key();
    const Json& row = entry.value();
    if (!row.contains("after_cc_steps")) continue;
    for (const Json& after : row["after_cc_steps"]) {
      const int steps = after["steps"].get<int>();
      CAPTURE(name);
      CAPTURE(steps);
      const ConeStudy s = study(mesh_of(name), steps);
      CHECK(status_of(s, static_cast<std::size_t>(steps)) == after["T1"].get<std::string>());
      CHECK(s.levels.back().patches == after["patches"].get<int>());
    }
  }
}

TEST_CASE("whether cones meet is decided where doubles see no difference") {
  const Rational tiny = Rational(1) / pow(Rational(10), 40);
  const auto test = [](const Vector3& u, const Vector3& v) { return test_cones({{u}, {v}}, true); };
  CHECK(test({1, 0, 0}, {1, tiny, 0}).separated());
  CHECK(test({1, 0, 0}, {-1, tiny, 0}).separated());
  const ConeTest same = test({1, 0, 0}, {3, 0, 0});
  CHECK(same.apart == false);
  CHECK(same.apart_from_opposite == true);
  const ConeTest opposite = test({1, 0, 0}, {-1, 0, 0});  // the printed condition holds, the corrected one does not
  CHECK(opposite.apart == true);
  CHECK(opposite.apart_from_opposite == false);
  const ConeTest line = test_cones({{{1, 0, 0}, {-1, 0, 0}}, {{0, 1, 0}}}, true);
  CHECK_FALSE(line.pointed_u);
  CHECK(line.pointed_v);
  CHECK_FALSE(line.apart.has_value());
  CHECK_FALSE(line.separated());
  const Differences with_zero{{{1, 0, 0}, {0, 0, 0}}, {{0, 1, 0}}};
  CHECK_FALSE(test_cones(with_zero, true).separated());
  CHECK(test_cones(with_zero, false).separated());
}

TEST_CASE("separated sectors and the gaps between them fill half a turn") {
  for (const char* name : {"grid_perturbed", "mech_part", "dolphin_like", "butterfly_like", "ce_reentrant"}) {
    CAPTURE(name);
    const ConeLevel level = study(mesh_of(name), 0).levels[0];
    REQUIRE(level.gap.has_value());
    REQUIRE(level.gap_to_opposite.has_value());
    CHECK(level.u.width + level.v.width + *level.gap + *level.gap_to_opposite == doctest::Approx(180).epsilon(1e-9));
    CHECK(*level.gap > 0);
    CHECK(*level.gap_to_opposite > 0);
  }
  // The sectors of the table: u around (1, 0), v around (-1, 0), both pointed.
  const ConeLevel level = study(mesh_of("ce_opposite"), 0).levels[0];
  CHECK(*level.gap > 0);
  CHECK(*level.gap_to_opposite < 0);
}

TEST_CASE("the extreme directions of a sector are exact") {
  const Differences d{{{2, -1, 0}, {1, 0, 0}, {3, 3, 0}, {6, 6, 0}}, {{0, 5, 0}}};
  Surface<Rational> unit = mesh_of("grid_regular");
  const ConeLevel grid = study(unit, 0).levels[0];
  CHECK(grid.u.directions == std::vector<Vector3>{{1, 0, 0}});
  CHECK(grid.v.directions == std::vector<Vector3>{{0, 1, 0}});
  CHECK(*grid.u.ends == std::array<Vector3, 2>{Vector3{1, 0, 0}, Vector3{1, 0, 0}});
  CHECK(*grid.gap == doctest::Approx(90));
  CHECK(test_cones(d, true).separated());
  // A shear by (1, -1/3) in x makes v-edges (-1/3, 1) and leaves u-edges (1, 0).
  const ConeLevel sheared = study(mapped(unit, {{{1, Rational(-1) / Rational(3), 0}, {0, 1, 0}, {0, 0, 1}}}, 0), 0).levels[0];
  CHECK(sheared.v.directions == std::vector<Vector3>{{-1, 3, 0}});
  CHECK(*sheared.gap_to_opposite == doctest::Approx(std::atan2(3, 1) * 180 / 3.14159265358979));
}

TEST_CASE("scaling moving and turning a mesh changes no cone but turns it") {
  const Rational c = Rational(3) / Rational(5), s = Rational(4) / Rational(5), big = pow(Rational(10), 25);
  for (const char* name : {"grid_perturbed", "ring8", "dolphin_like", "bump3d"}) {
    CAPTURE(name);
    const ConeLevel before = study(mesh_of(name), 0).levels[0];
    const ConeLevel turned = study(mapped(mesh_of(name), {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}}, 7), 0).levels[0];
    const ConeLevel scaled = study(mapped(mesh_of(name), {{{big, 0, 0}, {0, big, 0}, {0, 0, big}}}, 0), 0).levels[0];
    for (const ConeLevel* after : {&turned, &scaled}) {
      CHECK(after->test.separated() == before.test.separated());
      CHECK(after->u.directions.size() == before.u.directions.size());
      CHECK(after->u.width == doctest::Approx(before.u.width).epsilon(1e-7));
      CHECK(after->v.width == doctest::Approx(before.v.width).epsilon(1e-7));
      CHECK(after->gap.value_or(0) == doctest::Approx(before.gap.value_or(0)).epsilon(1e-7));
    }
    CHECK(scaled.u.from == doctest::Approx(before.u.from));
  }
}

TEST_CASE("the smallest round cone of the axes is centred on the diagonal") {
  const auto cone = smallest_round_cone({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  REQUIRE(cone.has_value());
  CHECK(cone->angle == doctest::Approx(std::acos(1 / std::sqrt(3.0)) * 180 / 3.14159265358979));
  for (const double x : cone->centre) CHECK(x == doctest::Approx(1 / std::sqrt(3.0)));
  CHECK(smallest_round_cone({{1, 0, 0}})->angle == doctest::Approx(0));
  CHECK_FALSE(smallest_round_cone({{1, 0, 0}, {-1, 0, 0}}).has_value());
  CHECK_FALSE(smallest_round_cone({{1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0}}).has_value());
}

TEST_CASE("the cones of a face narrow with every step") {
  const ConeStudy s = study(mesh_of("ring8"), 2, 3);
  CHECK_FALSE(s.levels[0].test.separated());  // T2 fails on all 24 patches at depth 0 and on none at depth 1
  CHECK(s.levels[1].test.separated());
  CHECK(s.levels[1].parts == 4);
  CHECK(s.levels[1].passed == 4);
  for (std::size_t k = 0; k + 1 < s.levels.size(); ++k) {
    CHECK(s.levels[k + 1].u.width < s.levels[k].u.width);
    CHECK(s.levels[k + 1].v.width < s.levels[k].v.width);
  }
  // u and v of the parts are those of the face: edges of the marked region have a family each.
  const auto& family = s.levels[2].family;
  CHECK(std::count(family.begin(), family.end(), 1) > 0);
  CHECK(std::count(s.levels[2].marked.begin(), s.levels[2].marked.end(), 1) == 16);
}

TEST_CASE("the verdict on a face is about each of its parts and not about all together") {
  Room room;
  // A fan of four faces around a hole: the net of a face turns by 270 degrees, so after two steps u of some part points where v
  // of another does; the differences of the parts are still separated each.
  std::ofstream(room.file("fan.obj"))
      << "v 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nv 2 0 0\nv 0 2 0\nv -2 0 0\nv 0 -2 0\nv 3 0 0\nv 0 3 0\nv -3 0 0\nv 0 -3 0\n"
         "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 5 6 10 9\nf 6 7 11 10\nf 7 8 12 11\nf 8 5 9 12\n";
  room.run("cones(load(\"fan.obj\"), face = 0) |> plot \"fan.svg\"");
  const Json value = to_json(room.run("cones(load(\"fan.obj\"), face = 0)"))["value"];
  const Json& level = value["levels"][2];
  CHECK(level["tested"] == 16);
  CHECK(level["passed"] == 16);
  CHECK(level["holds"] == true);
  CHECK(level["together"] == true);
  CHECK(level["separated"] == false);
  CHECK(level["u_apart_from_v"] == false);
  const ConeStudy s = study(with_one_face_corners(load<Rational>(room.file("fan.obj"))), 2, 0);
  CHECK(verdict_of(s.levels[2], s.subject) ==
        "T2 holds on all 16 parts; together: the cones of u and v meet, the cones of u and -v meet");
  CHECK_FALSE(s.levels[0].holds());
  CHECK(verdict_of(s.levels[0], s.subject).rfind("T2 fails: ", 0) == 0);
  CHECK(room.text("fan.svg").find("T2 holds on all 16 parts") != std::string::npos);
  CHECK(room.run("cones(load(\"fan.obj\"), face = 0)[2]").as<Boolean>()->value);
}

TEST_CASE("mode interior does not refine open meshes") {
  Room room;
  const Json open = to_json(room.run("cones(" + loaded("ring5") + ", mode = interior, steps = 2)"))["value"];
  CHECK(open["refined"] == false);
  CHECK(open["levels"].size() == 1);
  CHECK(room.run("cones(" + loaded("ring5") + ", interior)").as<ReportValue>()->text.find("has no boundary rule") !=
        std::string::npos);
  const Json closed = to_json(room.run("cones(" + loaded("torus3d") + ", mode = interior, steps = 1)"))["value"];
  CHECK(closed["refined"] == true);
  CHECK(closed["levels"].size() == 2);
  // The patches of mode interior are patches of mode bspline with the same nets: nothing about them is lost.
  const Json there = to_json(room.run("cones(grid(3, 3), steps = 0, face = 4)"))["value"]["levels"][0];
  CHECK(to_json(room.run("cones(grid(3, 3), mode = interior, face = 4)"))["value"]["levels"][0]["u"] == there["u"]);
  CHECK(room.error("cones(grid(2, 2), mode = interior, face = 0)") == "E_NO_PATCH");
}

TEST_CASE("components are compared one by one") {
  Room room;
  // Two grids, the second turned by a quarter: u of one is v of the other, so all edges together would not be separated.
  std::ofstream(room.file("two.obj")) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 0 0\nv 5 1 0\nv 4 1 0\nv 4 0 0\n"
                                         "f 1 2 3 4\nf 5 6 7 8\n";
  const Json level = to_json(room.run("cones(load(\"two.obj\"), steps = 0)"))["value"]["levels"][0];
  CHECK(level["tested"] == 2);
  CHECK(level["passed"] == 2);
  CHECK(level["separated"] == true);
}

TEST_CASE("differences are those of the expected patches") {
  Room room;
  for (const auto& entry : expected()["patches"].items()) {
    const std::string name = entry.key();
    const Json& patches = entry.value();
    for (const Json& patch : patches) {
      CAPTURE(name);
      const std::string face = std::to_string(patch["face"].get<int>());
      const Json report = to_json(room.run("differences(" + loaded(name) + ", " + face + ")"))["value"];
      CHECK(same_numbers(report["net"], patch["net"]));
      for (std::size_t k = 0; k < 4; ++k)
        for (const char* part : {"S", "Su", "Sv", "cross"})
          CHECK(same_numbers(report["corners"][k][part], patch["corners"][k][part]));
      std::size_t flags = 0;
      for (const Json& flag : patch["flags_bottom_right_top_left"]) flags += flag.get<bool>() ? 1 : 0;
      CHECK(report["boundary_sides"].size() == flags);
      for (const char* test : {"T2", "T3", "T4"}) CHECK(report["tests"][test]["holds"] == true);
    }
  }
  // A flagged side takes away a row of three, and the column of steps across it.
  const Json corner = to_json(room.run("differences(grid(3, 3, exact = yes), 0)"))["value"];
  CHECK(corner["u"].size() == 6);
  CHECK(corner["v"].size() == 6);
  CHECK(to_json(room.run("differences(" + loaded("ring8") + ", 0)"))["value"]["tests"]["T2"]["holds"] == false);
  CHECK(to_json(room.run("differences(" + loaded("ring8") + ", 0)"))["value"]["tests"]["T3"]["holds"] == true);
}

TEST_CASE("pictures of cones are well formed and show every edge") {
  Room room;
  room.run("cones(grid(3, 2), steps = 1) |> plot \"grid.svg\"");
  const std::string svg = room.text("grid.svg");
  const auto names = elements(svg);
  CHECK(std::count(names.begin(), names.end(), "svg") == 1);
  CHECK(lines_of_path(svg, 0) == 9);  // 3 edges in each of 3 rows
  CHECK(lines_of_path(svg, 1) == 8);
  CHECK(lines_of_path(svg, 5) == 30);  // after three pencils; 6 edges in each of 5 rows
  CHECK(lines_of_path(svg, 6) == 28);
  CHECK(lines_of_path(svg, 2) == 1);  // one direction each of -v, v and u
  CHECK(occurrences(svg, "T1 holds") == 2);
  CHECK(svg.find("nan") == std::string::npos);
  room.run("cones(grid(3, 2), steps = 1) |> plot \"again.svg\"");
  CHECK(room.text("again.svg") == svg);
}

TEST_CASE("pictures in space and of single patches are well formed") {
  Room room;
  for (const char* program : {"torus3d", "bump3d", "star5", "ring8", "ce_nonpointed", "ce_parallel", "cusp3d_dyadic"}) {
    CAPTURE(program);
    room.run("cones(" + loaded(program) + ", steps = 1) |> plot \"x.svg\"");
    const std::string svg = room.text("x.svg");
    CHECK_FALSE(elements(svg).empty());
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(occurrences(svg, " holds") + occurrences(svg, " fails") == 2);
  }
  room.run("cones(" + loaded("bump3d") + ", steps = 0) |> plot \"bump.svg\"");
  CHECK(occurrences(room.text("bump.svg"), ": in one half space") == 2);
  room.run("cones(cube(), steps = 2) |> plot \"cube.svg\"");
  CHECK(room.text("cube.svg").find("no regular patch at this level") != std::string::npos);
  room.run("differences(grid(3, 3), 4) |> plot \"patch.svg\"");
  CHECK(room.text("patch.svg").find("T2 holds") != std::string::npos);
}

TEST_CASE("cones differences and Jacobians refuse what they are not about") {
  Room room;
  CHECK(room.error("cones(tetrahedron())") == "E_NOT_QUADS");
  CHECK(room.error("jacobian(tetrahedron())") == "E_NOT_QUADS");
  CHECK(room.error("differences(octahedron(), 0)") == "E_NOT_QUADS");
  CHECK(room.error("differences(grid(3, 3), 9)") == "E_INDEX");
  CHECK(room.error("cones(grid(3, 3), face = -1)") == "E_INDEX");
  CHECK(room.error("differences(cube(), 0)") == "E_NO_PATCH");
  CHECK(room.error("differences(grid(3, 3), 0, mode = interior)") == "E_NO_PATCH");
  CHECK(room.error("differences(grid(3, 3), 4, mode = interior)").empty());
  CHECK(room.error("cones(cube(), face = 1)") == "E_NO_PATCH");
  CHECK(room.error("cones(cube(), steps = 1)") == "E_NO_PATCH");
  CHECK(room.error("cones(cube(), steps = 8)") == "E_MAX_FACES");
  CHECK(room.error("jacobian(cube(), steps = 9)") == "E_MAX_FACES");
  CHECK(room.error("cones(cube(), steps = -1)") == "E_TYPE");
  CHECK(room.error("cones(cube(), mode = \"other\")") == "E_TYPE");
  CHECK(room.error("cones(polygon(4))") == "E_TYPE");
  CHECK(room.error("cones(torus(5, 5, 3, 1, exact = yes))") == "E_NOT_EXACT");
}

TEST_SUITE_END();
