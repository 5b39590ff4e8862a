// Patches: values and derivatives against de Casteljau, curvature against known surfaces, and whole meshes of regular patches
// against the limit surface and against themselves after a step.
#include "operators/methods/filling/bezier_patch.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "operators/limit.h"
#include "operators/matrix.h"
#include "operators/methods/filling/patch_surface.h"
#include "operators/schemes.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/refusal.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

using Vector = Eigen::Vector3d;

Vector de_casteljau(std::vector<Vector> p, double t) {
  while (p.size() > 1) {
    for (std::size_t k = 0; k + 1 < p.size(); ++k) p[k] = (1 - t) * p[k] + t * p[k + 1];
    p.pop_back();
  }
  return p[0];
}

Vector point_of(const BezierPatch& patch, double u, double v) {
  std::vector<Vector> column;
  for (int j = 0; j <= patch.degree_u; ++j) {
    std::vector<Vector> row;
    for (int k = 0; k <= patch.degree_v; ++k) row.emplace_back(patch.points.row((patch.degree_v + 1) * j + k).transpose());
    column.push_back(de_casteljau(row, v));
  }
  return de_casteljau(column, u);
}

/// The patch of a derivative: differences of the points times the degree.
BezierPatch hodograph(const BezierPatch& p, bool by_u) {
  BezierPatch result{p.degree_u - (by_u ? 1 : 0), p.degree_v - (by_u ? 0 : 1), {}};
  result.points.resize((result.degree_u + 1) * (result.degree_v + 1), 3);
  for (int j = 0; j <= result.degree_u; ++j)
    for (int k = 0; k <= result.degree_v; ++k) {
      const int here = (p.degree_v + 1) * j + k, next = by_u ? here + p.degree_v + 1 : here + 1;
      result.points.row((result.degree_v + 1) * j + k) =
          (by_u ? p.degree_u : p.degree_v) * (p.points.row(next) - p.points.row(here));
    }
  return result;
}

BezierPatch random_patch(Dice& dice, int du, int dv) { return {du, dv, random_points<double>(dice, (du + 1) * (dv + 1), 3)}; }

/// The graph of a u^2 + b u v + c v^2 over the unit square.
BezierPatch graph(double a, double b, double c) {
  BezierPatch patch{2, 2, Points<double>(9, 3)};
  for (int j = 0; j < 3; ++j)
    for (int k = 0; k < 3; ++k) patch.points.row(3 * j + k) << j / 2.0, k / 2.0, a * (j == 2) + b * j * k / 4.0 + c * (k == 2);
  return patch;
}

double worst(const PatchSurface& coarse, const PatchSurface& fine) {
  // Half-edge h of the coarse cage becomes face h of the fine one, with its first corner at the vertex that h leaves.
  double result = 0;
  const Mesh& mesh = *coarse.cage.mesh;
  for (int h = 0; h < mesh.half_edges(); ++h) {
    if (!coarse.has_patch(mesh.face[Mesh::i(h)])) continue;
    REQUIRE(fine.has_patch(h));
    for (const double s : {0.0, 0.3, 1.0}) {
      for (const double t : {0.0, 0.6, 1.0}) {
        const auto [u0, v0] = on_side(coarse, h, s / 2);  // s along h, t along the edge before it, backwards
        const auto [u1, v1] = on_side(coarse, mesh.prev(h), 1 - t / 2);
        const auto [u2, v2] = on_side(coarse, h, 0);
        const PatchJet a = coarse.patches[Mesh::i(mesh.face[Mesh::i(h)])].at(u0 + u1 - u2, v0 + v1 - v2);
        result = std::max(result, (a.point - fine.patches[Mesh::i(h)].at(s, t).point).norm());
      }
    }
  }
  return result;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("a patch has the points of de Casteljau and the derivatives of its hodographs") {
    Dice dice(71);
    for (const auto& degrees : {std::pair{3, 3}, std::pair{7, 7}, std::pair{2, 5}, std::pair{1, 0}, std::pair{0, 1}}) {
      const int du = degrees.first, dv = degrees.second;
      CAPTURE(du);
      const BezierPatch patch = random_patch(dice, du, dv);
      for (const double u : {0.0, 0.25, 0.7, 1.0}) {
        for (const double v : {0.0, 0.4, 1.0}) {
          const PatchJet jet = patch.at(u, v);
          CHECK((jet.point - point_of(patch, u, v)).norm() <= 1e-13 * 30);
          const auto check = [&](const Vector& value, bool first, bool second, int order) {
            const int in_u = order == 1 ? first : first + second, in_v = order - in_u;
            if (in_u > du || in_v > dv) {
              CHECK(value.norm() == 0);
              return;
            }
            BezierPatch derived = hodograph(patch, first);
            if (order == 2) derived = hodograph(derived, second);
            CHECK((value - point_of(derived, u, v)).norm() <= 1e-13 * 30 * 42 * 4);
          };
          check(jet.u, true, false, 1);
          check(jet.v, false, false, 1);
          check(jet.uu, true, true, 2);
          check(jet.uv, true, false, 2);
          check(jet.vv, false, false, 2);
        }
      }
    }
  }

  TEST_CASE("curvature is that of graphs by the textbook") {
    for (const auto& [a, b, c] : {std::array{0.5, 0.0, 0.25}, std::array{1.0, -2.0, 0.3}, std::array{0.0, 1.0, 0.0}}) {
      const BezierPatch patch = graph(a, b, c);
      for (const double u : {0.0, 0.5, 1.0}) {
        for (const double v : {0.0, 0.8}) {
          const double fu = 2 * a * u + b * v, fv = b * u + 2 * c * v, g = 1 + fu * fu + fv * fv;
          const SurfaceCurvature here = curvature(patch.at(u, v));
          REQUIRE(here.is_regular);
          CHECK(here.gaussian == doctest::Approx((4 * a * c - b * b) / (g * g)).epsilon(1e-12));
          const double mean = ((1 + fv * fv) * 2 * a - 2 * fu * fv * b + (1 + fu * fu) * 2 * c) / (2 * std::pow(g, 1.5));
          CHECK(here.mean == doctest::Approx(mean).epsilon(1e-12));
          CHECK((here.normal - Vector(-fu, -fv, 1) / std::sqrt(g)).norm() <= 1e-14);
          CHECK((here.tensor * here.normal).norm() <= 1e-13);
          CHECK(here.second_form[1] == doctest::Approx(b / std::sqrt(g)).epsilon(1e-12));
        }
      }
    }
  }

  TEST_CASE("the curvature tensor does not depend on the parametrisation") {
    Dice dice(72);
    const PatchJet p = random_patch(dice, 4, 4).at(0.3, 0.6);
    // u = 2 x + y + x y, v = y - x/3 + x^2/2 at 0
    PatchJet q = p;
    q.u = 2 * p.u - p.v / 3;
    q.v = p.u + p.v;
    q.uu = 4 * p.uu - 4.0 / 3 * p.uv + p.vv / 9 + p.v;
    q.uv = 2 * p.uu + (2 - 1.0 / 3) * p.uv - p.vv / 3 + p.u;
    q.vv = p.uu + 2 * p.uv + p.vv;
    const SurfaceCurvature a = curvature(p), b = curvature(q);
    CHECK((a.tensor - b.tensor).norm() <= 1e-12 * a.tensor.norm());
    CHECK((a.normal - b.normal).norm() <= 1e-13);
    CHECK(a.gaussian == doctest::Approx(b.gaussian));
  }

  TEST_CASE("points without a tangent plane are counted and not measured") {
    BezierPatch flat{1, 1, Points<double>::Zero(4, 3)};
    flat.points(2, 0) = flat.points(3, 0) = 1;
    CurvatureExtrema range;
    range.include(flat, 3);
    CHECK(range.irregular == 9);
    CHECK(range.points == 0);
    CHECK_FALSE(curvature(flat.at(0.5, 0.5)).is_regular);
    CHECK_THROWS_AS((BezierPatch{3, 3, Points<double>::Zero(4, 3)}.at(0, 0)), Error);
  }

  TEST_CASE("regular patches have the limit points and normals of Catmull-Clark at their corners") {
    Dice dice(73);
    for (int trial = 0; trial < 12; ++trial) {
      CAPTURE(trial);
      Surface<double> surface = grid<double>(dice.between(1, 4), dice.between(1, 4));
      if (trial % 3 == 0) surface = torus<double>(4, 5, 3, 1);
      for (Eigen::Index i = 0; i < surface.points.rows(); ++i) surface.points(i, 2) += dice.fraction().to_double() / 20;
      surface = with_corners(std::move(surface));
      const Limit limits = limit(schemes::catmull_clark(), surface);
      const PatchSurface patches = regular_patches(surface);
      const Mesh& mesh = *surface.mesh;
      for (int h = 0; h < mesh.half_edges(); ++h) {
        REQUIRE(patches.has_patch(mesh.face[Mesh::i(h)]));
        const auto [u, v] = on_side(patches, h, 0);
        const PatchJet jet = patches.patches[Mesh::i(mesh.face[Mesh::i(h)])].at(u, v);
        const int vertex = mesh.vertex[Mesh::i(h)];
        CHECK((jet.point.transpose() - limits.points.row(vertex)).norm() <= 1e-13);
        CHECK((curvature(jet).normal.transpose() - limits.normals.row(vertex)).norm() <= 1e-10);
      }
    }
  }

  TEST_CASE("patches after a step are quarters of the patches before") {
    Dice dice(74);
    for (const NamedMesh& named : quad_meshes()) {
      CAPTURE(named.name);
      auto surface = with_corners(random_surface<double>(dice, named.mesh));
      CHECK(worst(regular_patches(surface), regular_patches(run(schemes::catmull_clark(), surface, 1))) <= 1e-13 * 30);
    }
  }

  TEST_CASE("regular patches meet with G2 also where points repeat on a torus of few faces") {
    const PatchSurface patches = regular_patches(torus<double>(5, 4, 3, 1));
    const JoinDefects defects = join_defects(patches);
    CHECK(defects.edges == 40);
    CHECK(defects.gap <= 1e-14);
    CHECK(defects.normal <= 1e-13);
    CHECK(defects.curvature <= 1e-12);
    CHECK(defects.irregular == 0);
  }

  TEST_CASE("hybrid patches of a mesh are watertight and C1 but not C2") {
    Dice dice(75);
    const Surface<double> surface = torus<double>(8, 6, 3, 1);
    std::vector<double> c;
    for (int v = 0; v < surface.mesh->vertices(); ++v) c.push_back(dice.between(1, 10) / 10.0);
    const JoinDefects defects = join_defects(regular_patches(surface, c));
    CHECK(defects.gap <= 1e-14);
    CHECK(defects.normal <= 1e-12);
    CHECK(defects.curvature > 0.01);
  }

  TEST_CASE("a defect of every kind is seen") {
    PatchSurface patches = regular_patches(torus<double>(5, 4, 3, 1));
    patches.patches[3].points.row(15) += Eigen::RowVector3d(0, 0, 1e-3);
    CHECK(join_defects(patches).gap == doctest::Approx(1e-3));
    patches = regular_patches(torus<double>(5, 4, 3, 1));
    patches.patches[3].points.row(5) += Eigen::RowVector3d(0, 0, 1e-3);
    const JoinDefects defects = join_defects(patches);
    CHECK(defects.gap <= 1e-14);
    CHECK(defects.normal > 1e-5);
    CHECK(defects.curvature > 1e-4);
  }

  TEST_CASE("a tessellation is a closed mesh on the patches with their normals") {
    const Surface<double> surface = torus<double>(6, 5, 3, 1);
    const PatchSurface patches = regular_patches(surface);
    for (const int n : {1, 2, 5}) {
      const Tessellation t = tessellate(patches, n);
      const Mesh& mesh = *t.surface.mesh;
      CHECK(mesh.faces() == 30 * n * n);
      CHECK(mesh.vertices() - mesh.edges() + mesh.faces() == 0);
      for (int e = 0; e < mesh.edges(); ++e) CHECK_FALSE(mesh.is_boundary_edge(e));
      double off = 0;  // normals follow the orientation of the faces
      for (int h = 0; h < mesh.half_edges(); ++h) {
        const Vector a = t.surface.points.row(mesh.vertex[Mesh::i(h)]), b = t.surface.points.row(mesh.tip(h)),
                     c = t.surface.points.row(mesh.vertex[Mesh::i(mesh.prev(h))]),
                     normal = t.normals.row(mesh.vertex[Mesh::i(h)]);
        const Vector x = b - a, y = c - a;
        off = std::min(off, Vector(x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]).dot(normal));
      }
      CHECK(off >= 0);
      CHECK((t.normals.rowwise().norm().array() - 1).abs().maxCoeff() <= 1e-14);
      if (n == 1) {  // the corners are limit points
        const Limit limits = limit(schemes::catmull_clark(), surface);
        std::multiset<double> expected, found;
        for (int v = 0; v < 30; ++v)
          expected.insert(std::round(limits.points.row(v).sum() * 1e9)),
              found.insert(std::round(t.surface.points.row(v).sum() * 1e9));
        CHECK(expected == found);
      }
    }
  }

  TEST_CASE("a tessellation with holes is a mesh even where two holes touch") {
    PatchSurface patches = regular_patches(with_corners(grid<double>(3, 3)));
    patches.patches[0].points.resize(0, 3);
    patches.patches[4].points.resize(0, 3);
    const Tessellation t = tessellate(patches, 2);
    CHECK(t.surface.mesh->faces() == 28);
    CHECK_THROWS_WITH_AS(tessellate(patches, 0), "a patch is cut into n x n quads with n from 1 to 1000, not 0", Error);
    RunControl control;
    control.max_faces = 100;
    CHECK_THROWS_WITH_AS(tessellate(patches, 1000, control), "the tessellation would have 7000000 faces; the limit is 100",
                         Error);
    for (BezierPatch& patch : patches.patches) patch.points.resize(0, 3);
    CHECK_THROWS_WITH_AS(tessellate(patches, 2), "the surface has no patch to tessellate", Error);
  }

  TEST_CASE("curvature at shared points of a tessellation is that of the patches") {
    const Surface<double> surface = torus<double>(24, 24, 3, 1);
    const Tessellation t = tessellate(regular_patches(surface), 3);
    // A torus has K = cos/(r (R + r cos)) between -1/2 and 1/4; the spline of 24 points is near it.
    const auto& gaussian = t.surface.attributes.at("gaussian");
    CHECK(*std::min_element(gaussian.begin(), gaussian.end()) == doctest::Approx(-0.5).epsilon(0.05));
    CHECK(*std::max_element(gaussian.begin(), gaussian.end()) == doctest::Approx(0.25).epsilon(0.05));
  }
}
