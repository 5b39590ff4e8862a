// interpolate, its report, figure and claims as programs write them.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "operators/methods/interpolation/interpolation.h"
#include "operators/schemes.h"
#include "tests/interpreter/room.h"

namespace {

using namespace udcp;
using oracle::Room;

/// A tetrahedron with normals as vn lines, the second one tilted.
class Files : public Room {
 public:
  Files() {
    std::ofstream(file("solid.obj")) << "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\n"
                                        "vn 1 1 1\nvn 2 -1 -1\nvn -1 1 -1\nvn -1 -1 1\n"
                                        "f 1//1 2//2 3//3\nf 1//1 4//4 2//2\nf 1//1 3//3 4//4\nf 2//2 4//4 3//3\n";
  }
  std::string text(const std::string& program) { return to_text(run(program)); }
  bool holds(const std::string& condition) { return run(condition).as<Boolean>()->value; }
  Surface<double> mesh(const std::string& program) { return std::get<Surface<double>>(run(program).as<MeshValue>()->shape); }
  Json json(const std::string& program) { return to_json(run(program))["value"]; }
};

const Eigen::RowVector3d tilted = Eigen::RowVector3d(2, -1, -1).normalized();

Eigen::RowVector3d normal_at(const Surface<double>& fine, int v) { return limit(schemes::catmull_clark(), fine).normals.row(v); }

}  // namespace

TEST_SUITE_BEGIN("interpreter");

TEST_CASE("interpolate without normals keeps exact meshes exact") {
  Files room;
  CHECK(room.text("points(interpolate(cube(exact = yes), step1 = local))[7]") == "[17/9, 17/9, 17/9]");
  // W = 39/(12 lambda + 14), and (3) on the cube: lambda W + (1 - lambda)(10/13 W/3 - 3/13 W/3)
  CHECK(room.text("points(interpolate(cube(exact = yes), lambda = 1))[7]") == "[3/2, 3/2, 3/2]");
  const Surface<double> fine = room.mesh("interpolate(load(\"solid.obj\"))");
  CHECK(fine.mesh->faces() == 12);
  CHECK((limit(schemes::catmull_clark(), fine).points.row(1) - Eigen::RowVector3d(1, -1, -1)).norm() < 1e-12);
  CHECK(room.error("interpolate(cube(exact = yes), normals = yes)") == "E_NOT_EXACT");
  CHECK(room.error("interpolate(cube(), method = kkt)") == "E_ARGUMENTS");
  CHECK(room.error("interpolate(cube(), flip = yes)") == "E_ARGUMENTS");
}

TEST_CASE("normals come from files attributes lists and functions") {
  Files room;
  CHECK((normal_at(room.mesh("interpolate(load(\"solid.obj\"), normals = yes)"), 1) - tilted).norm() < 1e-9);
  CHECK((normal_at(room.mesh("interpolate(load(\"solid.obj\"), normals = from(\"n\"))"), 1) - tilted).norm() < 1e-9);
  CHECK((normal_at(room.mesh("interpolate(tetrahedron(), normals = [[1,1,1], [2,-1,-1], [-1,1,-1], [-1,-1,1]])"), 1) - tilted)
            .norm() < 1e-9);
  CHECK(
      (normal_at(room.mesh("n(x, y, z) = [x + (x + y + z + 1)/2 + x*y*z*0, y, z]\ninterpolate(tetrahedron(), normals = n)"), 1) -
       Eigen::RowVector3d(1, -1, -1).normalized())
          .norm() < 1e-9);
  const Surface<double> own = room.mesh("interpolate(tetrahedron(), normals = yes)");  // of the faces around
  CHECK((normal_at(own, 1) - Eigen::RowVector3d(1, -1, -1).normalized()).norm() < 1e-9);
  CHECK(own.mesh->faces() == 4 * 12);
  CHECK(room.error("interpolate(cube(), normals = from(\"m\"))") == "E_ATTRIBUTE");
  CHECK(room.error("interpolate(cube(), normals = [])") == "E_NORMALS");
  CHECK(room.error("interpolate(cube(), normals = [[1, 0, 0]])") == "E_NORMALS");
  CHECK(room.error("interpolate(cube(), normals = [[1, 0]])") == "E_DIMENSION");
  CHECK(room.error("interpolate(cube(), normals = 3)") == "E_TYPE");
  CHECK(room.error("n(x, y, z) = [0, 0, 0]\ninterpolate(cube(), normals = n)") == "E_NORMAL");
}

TEST_CASE("options of interpolate are names and wrong ones are refused") {
  Files room;
  for (const std::string text :
       {"step1 = global", "step1 = local", "step1 = plain", "step2 = auto", "step2 = free", "step2 = tied", "step2 = rotate",
        "method = two_level", "lambda = 0.4", "free_points = [0, 1]", "free_normals = [2]",
        "method = literal, step2 = free, order = gauss, sweeps = 2", "method = kkt, step1 = local", "flip = no"}) {
    CAPTURE(text);
    CHECK(room.error("interpolate(load(\"solid.obj\"), normals = yes, " + text + ")").empty());
  }
  CHECK(room.error("interpolate(cube(), lambda = 7/20)") == "E_LAMBDA");
  CHECK(room.error("interpolate(cube(), step1 = sideways)") == "E_NAME");
  CHECK(room.error("interpolate(cube(), step1 = \"sideways\")") == "E_TYPE");
  CHECK(room.error("interpolate(cube(), step1 = free)") == "E_TYPE");
  CHECK(room.error("interpolate(cube(), free_points = [8])") == "E_INDEX");
  CHECK(room.error("global = 3\ninterpolate(cube(), step1 = global)").empty());
}

TEST_CASE("the report has a line and an entry per vertex") {
  Files room;
  const Json report = room.json("interpolation_report(load(\"solid.obj\"), step2 = tied)");
  REQUIRE(report["vertices"].size() == 4);
  CHECK(report["method"] == "method = two_level, step1 = global, lambda = 7/10, step2 = tied");
  CHECK(report["position_error"].get<double>() < 1e-14);
  CHECK(report["normal_error"].get<double>() < 1e-14);
  CHECK(report["vertices"][1]["correction"] == "tied");
  // the limit normal before is (1, -1, -1) by symmetry
  CHECK(report["vertices"][1]["angle_before"].get<double>() ==
        doctest::Approx(angle_between(tilted, Eigen::RowVector3d(1, -1, -1))));
  CHECK(report["vertices"][1]["displacement"].get<double>() > 0.01);
  CHECK(report["vertices"][0]["displacement"].get<double>() < 1e-14);
  const std::string text = room.text("interpolation_report(load(\"solid.obj\"), step2 = tied)");
  CHECK(text.find("\n1       19.4712\u00b0      tied        0.") != std::string::npos);
  CHECK(text.find("\n0       0\u00b0            tied        0\n") != std::string::npos);
  CHECK(room.text("interpolation_report(torus(12, 8, 3, 1))").find("(the 40 largest angles of 96;") != std::string::npos);
  CHECK(room.holds("interpolation_report(load(\"solid.obj\"))[0] < 1/10^12"));
  const Json swept = room.json("interpolation_report(load(\"solid.obj\"), method = literal, step2 = tied, sweeps = 7)");
  CHECK(swept["sweeps"].size() == 7);
  CHECK(swept["rounds"] == 1);
  CHECK(room.json("interpolation_report(load(\"solid.obj\"), method = kkt)")["rows"] == 20);
}

TEST_CASE("figures hold the cage both surfaces and a spike per normal") {
  Files room;
  const Surface<double> figure = room.mesh("interpolation_figure(load(\"solid.obj\"), rounds = 2, length = 1/2)");
  CHECK(figure.mesh->vertices() == 4 + 2 * 50 + 4 * 4);
  std::vector<int> count(4);
  for (const double part : figure.attributes.at("part")) ++count[static_cast<std::size_t>(part)];
  CHECK(count == std::vector<int>{4, 50, 50, 16});
  const Eigen::RowVector3d tip = figure.points.row(104 + 4 + 3), base = figure.points.middleRows(104 + 4, 3).colwise().mean();
  CHECK((tip - base - tilted / 2).norm() < 1e-12);
  CHECK(room.error("interpolation_figure(load(\"solid.obj\")) |> save \"figure.glb\"").empty());
  CHECK(std::filesystem::file_size(room.file("figure.glb")) > 1000);
  CHECK(room.error("interpolation_figure(cube(), rounds = 9)") == "E_TYPE");
}

TEST_CASE("interpolation is proved for exact input and refuted on the wrong side") {
  Files room;
  CHECK(room.verdict("prove interpolates(cube(exact = yes), step1 = local)") == "proved");
  CHECK(room.verdict("prove interpolates(load(\"solid.obj\"), lambda = 1/2, step2 = tied)") == "proved");
  CHECK(room.verdict("n(x, y, z) = [-x, -y, -z]\nprove interpolates(cube(exact = yes), normals = n, step1 = local)") ==
        "refuted");
  CHECK(room.verdict("prove interpolates(cube(), step2 = rotate)") == "undecided");
  CHECK(room.verdict("prove interpolates(cube(), method = kkt)") == "undecided");
  CHECK(room.verdict("prove interpolates(grid(2, 2))") == "undecided");
  CHECK(room.verdict("check interpolates(cube())") == "undecided");
  CHECK(room.verdict("prove iteration_converges(cube(), lambda = 7/10)") == "proved");
  CHECK(room.verdict("prove iteration_converges(cube(), lambda = 7/20)") == "refuted");
  CHECK(room.verdict("prove iteration_converges() for N in 3..8") == "proved");
  CHECK(room.error("prove interpolates(cube(), normals = [[0, 0, 0]])") == "E_NORMALS");
  (void)room.run("prove interpolates(cube(), step1 = local) -> \"cube.json\"");
  CHECK(room.json("verify \"cube.json\"")["accepted"] == true);
}

TEST_SUITE_END();
