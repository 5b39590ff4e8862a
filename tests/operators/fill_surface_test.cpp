// Filled surfaces: shapes near extraordinary vertices against plain Catmull-Clark, whole meshes with all their joins, and what is
// refused.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "operators/methods/filling/fill_g2.h"
#include "tests/operators/fill_golden.h"
#include "tests/oracle/nets.h"
#include "tests/oracle/obj_lines.h"
#include "tests/oracle/refusal.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

PatchSurface fill_net(const Points<double>& net, int n) {
  Surface<double> surface = ring_mesh(n, 3);
  surface.points = net;
  return fill_g2(surface);
}

CurvatureExtrema hole(const PatchSurface& surface, int v = 0, int samples = 9) {
  CurvatureExtrema range;
  for (const int f : face_rings(*surface.cage.mesh, v).inner) range.include(surface.patches[Mesh::i(f)], samples);
  return range;
}

std::vector<CurvatureExtrema> levels(const Points<double>& net, int n, int count) {
  Surface<double> surface = ring_mesh(n, 3);
  surface.points = net;
  return catmull_clark_curvature(surface, 0, count);
}

double largest(const CurvatureExtrema& range) { return std::max(std::abs(range.gaussian_low), std::abs(range.gaussian_high)); }

/// Equal to 1e-6 relative, or 1e-9 where the value vanishes.
bool close(double value, double expected) { return std::abs(value - expected) <= std::max(1e-6 * std::abs(expected), 1e-9); }

Surface<double> mesh_file(const std::string& name) {
  return as_surface(read_obj_lines(UDCP_TEST_DATA "/meshes/" + name + ".obj"));
}

FillOptions with_steps(int steps) {
  FillOptions options;
  options.steps = steps;
  return options;
}

int extraordinary(const Mesh& mesh) {
  int count = 0;
  for (int v = 0; v < mesh.vertices(); ++v) count += !mesh.on_boundary(v) && mesh.valence(v) != 4;
  for (int f = 0; f < mesh.faces(); ++f) count += mesh.size(f) != 4;
  return count;
}

void check_joins(const PatchSurface& surface) {
  const JoinDefects defects = join_defects(surface);
  CHECK(defects.irregular == 0);
  CHECK(defects.gap <= 1e-12 * size_of(surface.cage));
  CHECK(defects.normal <= 1e-10);
  CHECK(defects.curvature <= 1e-8);  // second differences of patches of size h lose eps/h^2
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("curvature of the fill and of Catmull-Clark by level have the reference values") {
    for (const Json& set : golden()["g2"]) {
      const int n = set["n"];
      for (const Json& net : set["nets"]) {
        if (!net.contains("centre")) continue;
        CAPTURE(net["name"].get<std::string>());
        const Points<double> points = points_of(net["points"]);
        const PatchSurface filled = fill_net(points, n);
        const SurfaceCurvature centre = curvature(filled.patches[Mesh::i(face_rings(*filled.cage.mesh, 0).inner[0])].at(0, 0));
        CHECK(close(centre.gaussian, net["centre"]["K"]));
        CHECK(close(centre.mean, net["centre"]["H"]));
        for (int k = 0; k < 3; ++k)
          CHECK(std::abs(centre.normal[k] - net["centre"]["normal"][Mesh::i(k)].get<double>()) <= 1e-11);
        const auto check = [](const CurvatureExtrema& range, const Json& expected) {
          CHECK(close(range.gaussian_low, expected["K_min"]));
          CHECK(close(range.gaussian_high, expected["K_max"]));
          CHECK(close(range.mean_low, expected["H_min"]));
          CHECK(close(range.mean_high, expected["H_max"]));
        };
        check(hole(filled), net["fill_9x9"]);
        const std::vector<CurvatureExtrema> by_level = levels(points, n, 6);
        for (int m = 0; m <= 6; ++m) check(by_level[Mesh::i(m)], net["catmull_clark_levels"][Mesh::i(m)]);
      }
    }
  }

  TEST_CASE("curvature grows per level by the ratios of the eigenvalues") {
    for (const auto& [text, expected] : golden()["catmull_clark_growth"].items()) {
      const int n = std::stoi(text);
      const double lambda = adjustable_eigenvalue(0.5, n, 1);
      const double saddle = n == 3 ? adjustable_eigenvalue(0.5, n, 1, false) : adjustable_eigenvalue(0.5, n, 2);
      CHECK(std::abs(lambda - expected["lambda1"].get<double>()) <= 1e-14);
      CHECK(std::abs(adjustable_cup_eigenvalue(0.5, n) / (lambda * lambda) - expected["rho_elliptic"].get<double>()) <= 1e-13);
      CHECK(std::abs(saddle / (lambda * lambda) - expected["rho_saddle"].get<double>()) <= 1e-13);
    }
  }

  TEST_CASE("near valence 5 and 6 the curvature of Catmull-Clark grows and that of the fill does not") {
    const auto saddle = levels(saddle_net(5), 5, 6), apex = levels(apex_net(5), 5, 6);
    CHECK(largest(saddle[6]) > 1.2 * largest(saddle[5]));
    CHECK(largest(apex[6]) > 1.1 * largest(apex[5]));
    const Points<double> corner = points_of(golden()["g2"][0]["nets"][0]["points"]);
    CHECK(largest(hole(fill_net(corner, 3))) <= 1.6 * largest(levels(corner, 3, 0)[0]));
    CHECK(largest(hole(fill_net(saddle_net(3), 3))) <= 1.6 * largest(levels(saddle_net(3), 3, 0)[0]));
    CHECK(largest(hole(fill_net(apex_net(5), 5))) <= 1.6 * largest(apex[0]));
    CHECK(largest(hole(fill_net(saddle_net(5), 5))) <= 1.6 * largest(saddle[0]));
    for (const Points<double>& net : {apex_net(6), saddle_net(6)})
      CHECK(2 * largest(hole(fill_net(net, 6))) < largest(levels(net, 6, 6)[6]));
  }

  TEST_CASE("the fill keeps the sign of the curvature") {
    CHECK(hole(fill_net(points_of(golden()["g2"][0]["nets"][0]["points"]), 3)).gaussian_low > 0);
    for (const int n : {5, 6}) CHECK(hole(fill_net(apex_net(n), n)).gaussian_low > 0);
    for (const int n : {3, 5, 6}) CHECK(hole(fill_net(saddle_net(n), n)).gaussian_high < 0);
  }

  TEST_CASE("a bowl keeps its curvature in the order of magnitude of the bowl") {
    Points<double> net = ring_mesh(5, 3).points;
    for (Eigen::Index i = 0; i < net.rows(); ++i) net(i, 2) = 0.1 * (net(i, 0) * net(i, 0) + net(i, 1) * net(i, 1));
    const PatchSurface filled = fill_net(net, 5);
    const double centre = curvature(filled.patches[Mesh::i(face_rings(*filled.cage.mesh, 0).inner[0])].at(0, 0)).gaussian;
    CHECK(centre == doctest::Approx(0.032).epsilon(0.02));
    CHECK(hole(filled).gaussian_high == doctest::Approx(0.047).epsilon(0.02));
  }

  TEST_CASE("real meshes become watertight surfaces with G2 along every edge") {
    for (const char* name : {"spot_control", "blub_control", "genus2_voxels"}) {
      CAPTURE(name);
      const Surface<double> mesh = mesh_file(name);
      const PatchSurface surface = fill_g2(mesh);
      CHECK(surface.steps == (mesh.mesh->all_faces_have(4) ? 1 : 2));
      CHECK(static_cast<int>(surface.filled.size()) == extraordinary(*mesh.mesh));
      for (int f = 0; f < surface.cage.mesh->faces(); ++f) CHECK(surface.has_patch(f));
      CHECK(join_defects(surface, 2).edges == surface.cage.mesh->edges());
      check_joins(surface);
      const Mesh fine = *tessellate(surface, 2).surface.mesh;
      CHECK(fine.vertices() - fine.edges() + fine.faces() == mesh.mesh->vertices() - mesh.mesh->edges() + mesh.mesh->faces());
    }
  }

  TEST_CASE("two holes that share an edge join there with G2") {
    const PatchSurface surface = fill_g2(trapezohedron(5));
    const Mesh& mesh = *surface.cage.mesh;
    CHECK(surface.steps == 1);
    CHECK(surface.filled.size() == 12);
    int between = 0;  // edges between a hole of valence 5 and one of valence 3
    for (int e = 0; e < mesh.edges(); ++e) {
      const int h = mesh.edge_half[Mesh::i(e)];
      int valences = 0;
      for (const int half : {h, mesh.twin[Mesh::i(h)]})
        valences += mesh.valence(mesh.vertex[Mesh::i(surface.first[Mesh::i(mesh.face[Mesh::i(half)])])]);
      between += valences == 8;
    }
    CHECK(between == 20);
    const JoinDefects defects = join_defects(surface);
    CHECK(defects.gap <= 1e-13);
    CHECK(defects.normal <= 1e-11);
    CHECK(defects.curvature <= 1e-9);
    check_joins(fill_g2(cube<double>()));
  }

  TEST_CASE("steps with another parameter shape the surface and keep it G2") {
    for (const double c : {0.2, 0.8, 0.0, 1.0}) {
      FillOptions options;
      options.c = {c};
      const PatchSurface surface = fill_g2(mesh_file("genus2_voxels"), options);
      CHECK(surface.steps == 1);
      const Surface<double> expected = run(schemes::adjustable(Rational::from_double(c)), mesh_file("genus2_voxels"), 1);
      CHECK((surface.cage.points - expected.points).cwiseAbs().maxCoeff() <= 1e-14);
      check_joins(surface);
    }
    FillOptions options;
    const Surface<double> spot = mesh_file("spot_control");
    for (int v = 0; v < spot.mesh->vertices(); ++v) options.c.push_back(v % 5 / 4.0);
    const PatchSurface surface = fill_g2(spot, options);
    CHECK(surface.steps == 2);
    check_joins(surface);
    // A regular mesh needs no step, but another parameter takes one unless it is told to stand.
    FillOptions tight;
    tight.c = {0.25};
    Surface<double> ring = torus<double>(5, 5, 3, 1);
    ring.points(0, 0) += 0.5;  // the even torus would be C2 by its symmetry
    CHECK(fill_g2(ring, tight).steps == 1);
    tight.steps = 0;
    const PatchSurface standing = fill_g2(ring, tight);
    CHECK(join_defects(standing).curvature > 1e-3);
    CHECK(join_defects(standing).normal <= 1e-12);
  }

  TEST_CASE("parameters that differ from 1/2 away from the holes leave the holes G2") {
    const Surface<double> mesh = run(schemes::catmull_clark(), mesh_file("cube"), 3);
    FillOptions options;
    options.steps = 0;
    options.c.assign(Mesh::i(mesh.mesh->vertices()), 0.5);
    // the middle of a face is three and more rings away from every corner
    for (int v = 8 + 12; v < 8 + 12 + 6; ++v) options.c[Mesh::i(v)] = 0.25;
    const PatchSurface surface = fill_g2(mesh, options);
    const JoinDefects defects = join_defects(surface);
    CHECK(defects.gap <= 1e-14);
    CHECK(defects.normal <= 1e-11);
    CHECK(defects.curvature > 1e-3);
    const Mesh& m = *mesh.mesh;
    PatchSurface holes = surface;  // only the holes and what touches them
    for (int f = 0; f < m.faces(); ++f) {
      bool near = false;
      for (const int v : surface.filled) {
        const FaceRings rings = face_rings(m, v);
        for (const auto& list : {rings.inner, rings.outer}) near |= std::find(list.begin(), list.end(), f) != list.end();
      }
      bool other = false;
      for (const int v : m.corners(f)) other |= options.c[Mesh::i(v)] != 0.5;
      if (!near || other) holes.patches[Mesh::i(f)].points.resize(0, 3);
    }
    CHECK(join_defects(holes).edges >= 8 * (3 + 6));
    CHECK(join_defects(holes).curvature <= 1e-9);
    options.c[8] = 0.25;  // on an edge of the cube, four rings from its ends: still allowed
    CHECK(fill_g2(mesh, options).filled.size() == 8);
    const std::vector<int> ring = ring_vertices(m, m.outgoing[3], 2);
    options.c[Mesh::i(ring.back())] = 0.25;
    CHECK(refusal([&] { fill_g2(mesh, options); }) == "E_FILL_C: vertex 3 cannot be filled: c is 0.25 at vertex " +
                                                          std::to_string(ring.back()) +
                                                          " in its two rings, where the fill needs 1/2");
  }

  TEST_CASE("what cannot be filled is refused with the vertex and the steps that help") {
    const auto help = [](auto call) {
      try {
        call();
      } catch (const Error& error) {
        return error.help;
      }
      return std::string("accepted");
    };
    const Surface<double> cube_mesh = mesh_file("cube");
    CHECK(refusal([&] { fill_g2(cube_mesh, with_steps(0)); }) ==
          "E_FILL_ISOLATED: vertex 0 of valence 3 cannot be filled: vertex 2 of the faces around it has valence 3, not 4");
    CHECK(help([&] { fill_g2(cube_mesh, with_steps(0)); }) ==
          "1 Catmull-Clark step makes it possible: steps = 1, or steps = auto");
    const Surface<double> prism_mesh{std::make_shared<const Mesh>(prism(5)), Points<double>::Random(10, 3), {}, {}};
    for (const int steps : {0, 1}) {
      CHECK(refusal([&] { fill_g2(prism_mesh, with_steps(steps)); }) ==
            "E_FILL_ISOLATED: vertex 4 is a corner of face 0, which has 5 corners; the fill needs quads");
      CHECK(help([&] { fill_g2(prism_mesh, with_steps(steps)); }) ==
            "2 Catmull-Clark steps make it possible: steps = 2, or steps = auto");
    }
    CHECK(fill_g2(prism_mesh).steps == 2);
    CHECK(refusal([&] { fill_g2(ring_mesh(5, 1), with_steps(0)); }) ==
          "E_FILL_ISOLATED: vertex 0 of valence 5 cannot be filled: vertex 1 of the faces around it is on the boundary");
    CHECK(fill_g2(ring_mesh(5, 1)).steps == 1);
    CHECK(refusal([&] { fill_g2(cube_mesh, with_steps(21)); }) == "E_FILL_STEPS: the number of steps is 21; it can be 0 to 20");
    CHECK(refusal([&] {
            fill_g2(Surface<double>{std::make_shared<const Mesh>(make_mesh(5, Faces{{0, 1, 2, 3}, {0, 3, 2, 4}, {0, 4, 2, 1}})),
                                    Points<double>::Random(5, 3),
                                    {},
                                    {}});
          }) == "E_FILL_VALENCE: vertex 1 has valence 2; there is no fill below 3, and steps do not change it");
    CHECK(refusal([&] { (void)fill_g2(ring_mesh(101, 2)); }) ==
          "E_FILL_VALENCE: vertex 0 has valence 101; fills are made up to 100");
  }

  TEST_CASE("a boundary vertex with three faces is refused or left out") {
    Surface<double> l{std::make_shared<const Mesh>(l_shape()), Points<double>::Random(8, 3), {}, {}};
    CHECK(refusal([&] { fill_g2(l); }) ==
          "E_FILL_BOUNDARY: vertex 4 is on the boundary with 3 faces; there are patches for two faces on a boundary or one at a "
          "corner, and "
          "steps do not change it");
    FillOptions options;
    options.leave_out = true;
    options.steps = 1;
    const PatchSurface surface = fill_g2(l, options);
    int missing = 0;
    for (int f = 0; f < surface.cage.mesh->faces(); ++f) missing += !surface.has_patch(f);
    CHECK(missing == 3);
    CHECK(surface.cage.mesh->faces() == 12);
    CHECK(join_defects(surface).curvature <= 1e-9);
  }

  TEST_CASE("parameters and points that make no sense are refused with their vertex") {
    const Surface<double> mesh = cube<double>();
    FillOptions options;
    options.c = {1.5};
    CHECK(refusal([&] { fill_g2(mesh, options); }) == "E_ADJUSTABLE_C: c = 1.5 is not between 0 and 1");
    options.c = {0.5, 0.5};
    CHECK(refusal([&] { fill_g2(mesh, options); }) == "E_ATTRIBUTE_SIZE: c has 2 values for 8 vertices");
    options.c.assign(8, 0.5);
    options.c[6] = -0.25;
    CHECK(refusal([&] { fill_g2(mesh, options); }) == "E_ADJUSTABLE_C: c = -0.25 at vertex 6 is not between 0 and 1");
    options.c[6] = std::numeric_limits<double>::quiet_NaN();
    CHECK(refusal([&] { fill_g2(mesh, options); }).starts_with("E_ADJUSTABLE_C: c = nan at vertex 6"));
    options.c = {0};
    options.steps = 0;
    CHECK(refusal([&] { fill_g2(torus<double>(5, 5, 3, 1), options); }) ==
          "E_ADJUSTABLE_C: c = 0 at vertex 0 has no smooth limit; without steps c must be above 0");
    Surface<double> broken = mesh;
    broken.points(3, 1) = std::numeric_limits<double>::infinity();
    CHECK(refusal([&] { fill_g2(broken); }) == "E_NOT_FINITE: coordinate 1 of vertex 3 is not finite");
    broken = mesh;
    broken.points = Points<double>::Zero(8, 4);
    CHECK(refusal([&] { fill_g2(broken); }) == "E_DIMENSION: the points have 4 coordinates, not 3");
    CHECK(refusal([&] { catmull_clark_curvature(mesh, 0, 2); }) ==
          "E_FILL_ISOLATED: vertex 0 has no two rings of regular vertices around it");
    CHECK(refusal([&] { catmull_clark_curvature(mesh, 8, 2); }) == "E_INDEX: there is no interior vertex 8");
  }

  TEST_CASE("a fill stops when it is told to and keeps to the limit of faces") {
    const std::atomic<bool> stop = true;
    FillOptions options;
    options.control.stop = &stop;
    CHECK(refusal([&] { fill_g2(cube<double>(), options); }) == "E_INTERRUPTED: interrupted");
    options.control.stop = nullptr;
    options.control.max_faces = 20;
    CHECK(refusal([&] { fill_g2(cube<double>(), options); }) == "E_MAX_FACES: the result would have 24 faces; the limit is 20");
  }

  TEST_CASE("points that coincide are filled like any others") {
    Surface<double> mesh = cube<double>();
    mesh.points.row(1) = mesh.points.row(0);
    const JoinDefects defects = join_defects(fill_g2(mesh));
    CHECK(defects.gap <= 1e-14);
  }
}
