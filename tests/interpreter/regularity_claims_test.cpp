// regular(mesh) as programs write it: verdicts of files, options, certificates, and what is refused.
#include <doctest/doctest.h>

#include <fstream>

#include "tests/interpreter/room.h"

namespace {

using namespace udcp;
using oracle::Room;
namespace fs = std::filesystem;

/// A room with the regularity meshes.
class Meshes : public Room {
 public:
  Meshes() {
    for (const auto& entry : fs::directory_iterator(UDCP_TEST_DATA "/regularity"))
      fs::copy_file(entry.path(), file(entry.path().filename().string()));
  }
};

}  // namespace

TEST_SUITE_BEGIN("interpreter");

TEST_CASE("meshes from files are decided on their decimals") {
  Meshes room;
  CHECK(room.verdict("prove regular(load(\"grid_perturbed.obj\"))") == "proved");
  CHECK(room.verdict("prove regular(load(\"star5.obj\"), catmull_clark)") == "proved");
  CHECK(room.verdict("prove regular(load(\"touch_dyadic.obj\"))") == "refuted");
  // The Jacobian touches 0 on these decimals. Their nearest doubles have another surface, so the file must have been read again.
  CHECK(room.verdict("prove regular(load(\"touch_nondyadic.obj\"))") == "undecided");
  CHECK(room.verdict("prove regular(load(\"touch_nondyadic.obj\", exact = yes))") == "undecided");
  CHECK(room.verdict("regular(load(\"torus3d.obj\"))") == "proved");
}

TEST_CASE("tests modes depths and exceptions of regularity can be chosen") {
  Meshes room;
  CHECK(room.verdict("prove regular(load(\"ring5.obj\"), test = T2, depth = 1)") == "undecided");
  CHECK(room.verdict("prove regular(load(\"ring5.obj\"), test = T2, depth = 2)") == "proved");
  CHECK(room.verdict("prove regular(load(\"ring5.obj\"), test = T3, depth = 0)") == "proved");
  CHECK(room.verdict("prove regular(load(\"ring5.obj\"), test = T4, depth = 0)") == "proved");
  CHECK(room.verdict("prove regular(load(\"ce_reentrant.obj\"), mode = interior)") == "proved");
  CHECK(room.verdict("prove regular(load(\"ce_reentrant.obj\"), mode = bspline)") == "refuted");
  CHECK(room.verdict("prove regular(load(\"mech_part.obj\"))") == "undecided");
  CHECK(room.verdict("prove regular(load(\"mech_part.obj\"), except = boundary)") == "proved");
  CHECK(room.verdict("prove regular(load(\"grid_regular.obj\"), corners = tagged)") == "undecided");
}

TEST_CASE("the surface of the cube is proved regular and its certificate comes back accepted") {
  Meshes room;
  std::ofstream(room.file("cube.obj")) << "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
                                          "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  CHECK(room.verdict("prove regular(load(\"cube.obj\")) -> \"cube.json\"") == "proved");
  (void)room.run("verify \"cube.json\"");
  CHECK(room.outcome() == Outcome::done);
}

TEST_CASE("regularity is refused where it means nothing") {
  Meshes room;
  CHECK(room.error("prove regular(catmull_clark)") == "E_TYPE");
  CHECK(room.error("prove regular(grid(3, 3), mode = both)") == "E_TYPE");
  CHECK(room.error("prove regular(grid(3, 3), test = \"T5\")") == "E_TYPE");
  CHECK(room.error("prove regular(triangulate(grid(2, 2)), mode = interior)") == "E_NOT_QUADS");
  CHECK(room.verdict("prove regular(grid(3, 3), (UC)*)") == "undecided");
  CHECK(room.verdict("prove regular(grid(1, 1), mode = interior)") == "undecided");
  CHECK(room.verdict("check regular(grid(3, 3))") == "undecided");
  CHECK(room.error("prove regular(icosahedron(exact = yes))") == "E_NOT_EXACT");
  CHECK(room.error("prove regular(cube()) for N in 3 .. 5") == "E_DOMAIN");
  CHECK(room.error("prove regular(grid(3, 3), test = T1)") == "E_TYPE");
}

TEST_CASE("words that are not the one of Catmull and Clark are not proved regular") {
  Meshes room;
  const std::string word = "w = (U C[ngon = classic] P)* where omega = 0, delta(N) = (N-4)/N";
  CHECK(room.verdict(word + "\nprove regular(torus(4, 4, 3, 1), w)") == "proved");
  for (const std::string extra : {"f@lat = -3", "omega@lat = 1", "f@lon = 2", "rings = lat"})
    CHECK(room.verdict(word + ", " + extra + "\nprove regular(torus(4, 4, 3, 1), w)") == "undecided");
}

TEST_CASE("parameters of programs may have the names of choices") {
  Meshes room;
  (void)room.run("bspline = 7\nf(test) = test + 1\nassert f(test = 2) == 3\ng(mode) = mode + 1\nassert g(mode = bspline) == 8");
  CHECK(room.outcome() == Outcome::done);
  CHECK(room.verdict("prove regular(grid(2, 2), mode = bspline)") == "proved");
}
