// Step 2 and the two-level method: normals against the limit code, invariances, boundaries, what holds where.
#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include "operators/limit.h"
#include "operators/methods/interpolation/ring_tangents.h"
#include "operators/schemes.h"
#include "tests/operators/interpolation_golden.h"
#include "tests/oracle/inputs.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

std::size_t at(int k) { return Mesh::i(k); }

std::vector<NamedMesh> closed_meshes() {
  return {{"cube", *cube<Rational>().mesh},
          {"torus", *torus<double>(4, 3, 2, 1).mesh},
          {"dodecahedron", dodecahedron()},
          {"prism 5", prism(5)},
          {"prism 7", prism(7)},
          {"tetrahedron", *tetrahedron<Rational>().mesh},
          {"icosahedron", *icosahedron<double>().mesh}};
}

InterpolateOptions options_of(PointStep step1, NormalStep step2) {
  InterpolateOptions options;
  options.step1 = step1;
  options.step2 = step2;
  return options;
}

// Whatever the input: the limits by another way (limit.h) are the points and normals.
void check_by_limits(const Surface<double>& cage, const Points<double>& normals, const Interpolation& result) {
  const Limit limits = limit(schemes::catmull_clark(), result.control);
  const int count = cage.mesh->vertices();
  CHECK((limits.points.topRows(count) - cage.points).cwiseAbs().maxCoeff() < 1e-10);
  for (int v = 0; v < count; ++v) {
    const Correction done = result.vertices[at(v)].correction;
    if (done == Correction::none || done == Correction::fixed || done == Correction::no_plane) continue;
    CAPTURE(v);
    const double off = result.vertices[at(v)].off_boundary;
    CHECK(std::abs(angle_between(limits.normals.row(v), normals.row(v)) - off) < 1e-6);
  }
}

// The same mesh with faces in another order and starting at other corners: fans then start elsewhere.
Surface<double> shuffled(const Surface<double>& surface, Dice& dice) {
  Faces faces = faces_of(*surface.mesh);
  for (std::size_t k = 1; k < faces.size(); ++k) std::swap(faces[k], faces[at(dice.below(static_cast<int>(k) + 1))]);
  for (auto& face : faces) std::rotate(face.begin(), face.begin() + dice.below(static_cast<int>(face.size())), face.end());
  return {std::make_shared<const Mesh>(make_mesh(surface.mesh->vertices(), faces)), surface.points, {}, {}};
}

double largest(const Interpolation& a, const Interpolation& b, double scale) {
  double result = 0;
  for (std::size_t v = 0; v < a.vertices.size(); ++v) {
    result = std::max(result, std::abs(a.vertices[v].angle_before - b.vertices[v].angle_before));
    result = std::max(result, std::abs(scale * a.vertices[v].displacement - b.vertices[v].displacement));
  }
  return result;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("rings of different vertices have no point in common after two steps") {
    std::vector<NamedMesh> meshes = closed_meshes();
    for (NamedMesh& named : quad_meshes()) meshes.push_back(std::move(named));
    for (NamedMesh& named : polygon_meshes()) meshes.push_back(std::move(named));
    for (const NamedMesh& named : meshes) {
      CAPTURE(named.name);
      Dice dice(81);
      const auto fine = run(schemes::catmull_clark(), random_surface<double>(dice, named.mesh), 2);
      std::vector<int> owner(at(fine.mesh->vertices()), -1);
      Fan fan;
      bool disjoint = true;
      for (int v = 0; v < named.mesh.vertices(); ++v) {
        collect_fan(*fine.mesh, v, fan);
        for (std::size_t k = 0; k < fan.e.size() + fan.f.size(); ++k) {
          const int i = fan_point(fan, k);
          disjoint = disjoint && owner[at(i)] < 0 && i >= named.mesh.vertices();
          owner[at(i)] = v;
        }
      }
      CHECK(disjoint);
    }
  }

  TEST_CASE("points and normals are interpolated on closed meshes of any polygons") {
    for (const NamedMesh& named : closed_meshes()) {
      CAPTURE(named.name);
      Dice dice(82);
      const auto cage = random_surface<double>(dice, named.mesh);
      const Points<double> normals = random_points<double>(dice, named.mesh.vertices(), 3);
      for (const PointStep step1 : {PointStep::global, PointStep::local, PointStep::plain}) {
        const Interpolation result = interpolate(cage, normals, options_of(step1, NormalStep::automatic));
        CHECK(result.errors.position < 1e-12 * 30);
        CHECK(result.errors.normal < 1e-10);  // tangents of random cages may nearly cancel
        CHECK(result.errors.reversed == 0);
        check_by_limits(cage, normals, result);
        for (const VertexReport& report : result.vertices)
          CHECK((report.correction == Correction::free) == (std::cos(report.angle_before) > 0.1));
      }
    }
  }

  TEST_CASE("projection replaces the tangents by their projections and keeps the limit point and the side") {
    Dice dice(83);
    const auto fine = run(schemes::catmull_clark(), random_surface<double>(dice, prism(7)), 2);
    const Points<double> normals = random_points<double>(dice, 14, 3);
    const Points<double> before = limit_points(fine, 14);
    RingMasks masks;
    Fan fan;
    for (const NormalStep step : {NormalStep::free, NormalStep::tied, NormalStep::rotate}) {
      const TurnedNormals turned = turn_normals(fine, normals, {step, {}});
      Surface<double> after = fine;
      after.points = turned.points;
      CHECK((limit_points(after, 14) - before).cwiseAbs().maxCoeff() < 1e-12 * 30);
      for (int v = 0; v < 14; ++v) {
        collect_fan(*fine.mesh, v, fan);
        const RingTangents a = tangents_at(fine.points, v, fan, *masks.weights(fan));
        const RingTangents b = tangents_at(after.points, v, fan, *masks.weights(fan));
        const Eigen::RowVector3d n = Eigen::RowVector3d(normals.row(v)).normalized();
        if (step == NormalStep::rotate) {
          CHECK(std::abs(normal_of(b).norm() - normal_of(a).norm()) < 1e-12 * normal_of(a).norm());
          CHECK(angle_between(normal_of(b), n) < 1e-10);
          CHECK(std::abs(b.first.norm() - a.first.norm()) < 1e-11);
          continue;
        }
        CHECK((b.first - (a.first - a.first.dot(n) * n)).norm() < 1e-11);
        CHECK((b.second - (a.second - a.second.dot(n) * n)).norm() < 1e-11);
        CHECK(std::abs(normal_of(b).dot(n) - normal_of(a).dot(n)) < 1e-10);
        CHECK(std::abs(turned.reports[at(v)].length_ratio - std::abs(std::cos(turned.reports[at(v)].angle_before))) < 1e-9);
      }
    }
  }

  TEST_CASE("free corrections are the cheaper ones in total") {
    for (const std::string& name : golden_names()) {
      CAPTURE(name);
      const GoldenMesh mesh = golden_mesh(name);
      const auto free = interpolate(mesh.cage, mesh.normals, options_of(PointStep::global, NormalStep::free));
      const auto tied = interpolate(mesh.cage, mesh.normals, options_of(PointStep::global, NormalStep::tied));
      for (std::size_t v = 0; v < free.vertices.size(); ++v)
        CHECK(free.vertices[v].squared_displacement <= tied.vertices[v].squared_displacement * (1 + 1e-12) + 1e-28);
    }
  }

  TEST_CASE("motions and scalings of points and normals move and scale the result") {
    const Eigen::Matrix3d turn = Eigen::Quaterniond(0.5, -0.1, 0.7, 0.5).normalized().toRotationMatrix();
    for (const std::string& name : golden_names()) {
      CAPTURE(name);
      const GoldenMesh mesh = golden_mesh(name);
      for (const NormalStep step : {NormalStep::free, NormalStep::tied, NormalStep::rotate}) {
        const InterpolateOptions options = options_of(PointStep::global, step);
        const Interpolation expected = interpolate(mesh.cage, mesh.normals, options);
        Surface<double> moved = mesh.cage;
        moved.points = ((3 * mesh.cage.points * turn.transpose()).rowwise() + Eigen::RowVector3d(1, -2, 0.5)).eval();
        const Interpolation result = interpolate(moved, 7 * mesh.normals * turn.transpose(), options);
        const Points<double> image = (3 * expected.control.points * turn.transpose()).rowwise() + Eigen::RowVector3d(1, -2, 0.5);
        CHECK((result.control.points - image).cwiseAbs().maxCoeff() < 1e-12);
        CHECK(largest(expected, result, 3) < 1e-11);
      }
    }
  }

  TEST_CASE("neither the start of a fan nor the order of faces matters") {
    Dice dice(84);
    for (const std::string& name : golden_names()) {
      CAPTURE(name);
      const GoldenMesh mesh = golden_mesh(name);
      const Surface<double> other = shuffled(mesh.cage, dice);
      for (const NormalStep step : {NormalStep::automatic, NormalStep::free, NormalStep::tied, NormalStep::rotate}) {
        const InterpolateOptions options = options_of(PointStep::global, step);
        const Interpolation a = interpolate(mesh.cage, mesh.normals, options), b = interpolate(other, mesh.normals, options);
        CHECK(largest(a, b, 1) < 1e-11);
        CHECK((limit_points(a.control, mesh.cage.mesh->vertices()) - limit_points(b.control, mesh.cage.mesh->vertices()))
                  .cwiseAbs()
                  .maxCoeff() < 1e-13);
        // the same points, wherever they are numbered
        std::vector<std::array<long, 3>> left, right;
        const auto collect = [](const Points<double>& points, std::vector<std::array<long, 3>>& list) {
          for (Eigen::Index i = 0; i < points.rows(); ++i)
            list.push_back({std::lround(points(i, 0) * 1e6 + 0.3), std::lround(points(i, 1) * 1e6 + 0.3),
                            std::lround(points(i, 2) * 1e6 + 0.3)});
          std::sort(list.begin(), list.end());
        };
        collect(a.control.points, left);
        collect(b.control.points, right);
        CHECK(left == right);
      }
    }
  }

  TEST_CASE("vertices without a prescribed normal are left alone") {
    const GoldenMesh mesh = golden_mesh("cone");
    InterpolateOptions options;
    options.skipped_normals.assign(at(50), 0);
    options.skipped_normals[0] = options.skipped_normals[7] = 1;
    Points<double> normals = mesh.normals;
    normals.row(7).setZero();  // not looked at
    const Interpolation result = interpolate(mesh.cage, normals, options);
    const Interpolation without = interpolate(mesh.cage, {}, options);
    CHECK(without.vertices.empty());
    CHECK(result.errors.position < 1e-12);
    CHECK(result.errors.normal < 1e-12);
    CHECK(result.vertices[7].correction == Correction::none);
    Fan fan;
    for (const int v : {0, 7, 20}) {
      collect_fan(*result.control.mesh, v, fan);
      const double moved = (result.control.points.row(fan.e[0]) - without.control.points.row(fan.e[0])).norm();
      CHECK((moved == 0) == (v != 20));
    }
  }

  TEST_CASE("on open meshes boundary curves stay and normals are those across them") {
    Dice dice(85);
    for (const NamedMesh& named : {NamedMesh{"L", l_shape()},
                                   {"star 5", *ring_mesh(5, 2).mesh},
                                   {"star 3", *ring_mesh(3, 2).mesh},
                                   {"mixed", polygon_meshes().back().mesh},
                                   {"fan 3", fan_mesh(3, false)},
                                   {"fan 6", fan_mesh(6, false)}}) {
      CAPTURE(named.name);
      const auto cage = random_surface<double>(dice, named.mesh);
      const Points<double> normals = random_points<double>(dice, named.mesh.vertices(), 3);
      const Interpolation without = interpolate(cage, {});
      for (const NormalStep step : {NormalStep::automatic, NormalStep::rotate}) {
        const Interpolation result = interpolate(cage, normals, options_of(PointStep::global, step));
        CHECK_FALSE(result.is_closed);
        CHECK(result.errors.position < 1e-12 * 30);
        CHECK(result.errors.normal < 1e-10);
        CHECK(result.errors.reversed == 0);
        check_by_limits(cage, normals, result);
        const Mesh& fine = *result.control.mesh;
        for (int v = 0; v < fine.vertices(); ++v)
          if (fine.on_boundary(v)) CHECK((result.control.points.row(v) - without.control.points.row(v)).norm() == 0);
        for (int v = 0; v < named.mesh.vertices(); ++v) {
          const VertexReport& report = result.vertices[at(v)];
          CHECK((report.correction == Correction::fixed) == (named.mesh.on_boundary(v) && named.mesh.valence(v) == 2));
          CHECK((report.correction == Correction::no_plane) == (named.mesh.on_boundary(v) && named.mesh.valence(v) > 4));
          CHECK((report.off_boundary > 0) ==
                (named.mesh.on_boundary(v) && named.mesh.valence(v) > 2 && named.mesh.valence(v) < 5));
        }
      }
    }
  }

  TEST_CASE("normals across the boundary curve are met exactly") {
    // a paraboloid over a grid with rounded corners: the normals of the graph, without their part along the boundary
    Surface<double> cage = grid<double>(6, 5);
    for (Eigen::Index v = 0; v < cage.points.rows(); ++v) {
      const double x = cage.points(v, 0) - 3, y = cage.points(v, 1) - 2.5;
      cage.points(v, 2) = (x * x + x * y - y * y) / 6;
    }
    Points<double> normals(cage.points.rows(), 3);
    const Surface<double> fine = interpolate(cage, {}).control;
    RingMasks masks;
    Fan fan;
    for (int v = 0; v < cage.mesh->vertices(); ++v) {
      const double x = cage.points(v, 0) - 3, y = cage.points(v, 1) - 2.5;
      Eigen::RowVector3d n(-(2 * x + y) / 6, -(x - 2 * y) / 6, 1);
      collect_fan(*fine.mesh, v, fan);
      if (!fan.inside && fan.faces() > 1) {
        const Eigen::RowVector3d along = tangents_at(fine.points, v, fan, *masks.weights(fan)).first.normalized();
        n -= n.dot(along) * along;
      }
      normals.row(v) = n;
    }
    const Interpolation result = interpolate(cage, normals);
    CHECK(result.errors.normal < 1e-12);
    const Limit limits = limit(schemes::catmull_clark(), result.control);
    for (int v = 0; v < cage.mesh->vertices(); ++v) {
      if (cage.mesh->valence(v) == 2) continue;
      CHECK(result.vertices[at(v)].off_boundary < 1e-12);
      CHECK(angle_between(limits.normals.row(v), normals.row(v)) < 1e-7);
    }
  }

  TEST_CASE("corners keep their points and their normals") {
    Dice dice(86);
    Surface<double> cage = random_surface<double>(dice, *ring_mesh(5, 2).mesh);
    cage.tags = random_corners(dice, *cage.mesh, 2);
    const Interpolation result = interpolate(cage, random_points<double>(dice, cage.mesh->vertices(), 3));
    int corners = 0;
    for (int v = 0; v < cage.mesh->vertices(); ++v) {
      if (!cage.tags.is_corner(v)) continue;
      ++corners;
      CHECK(result.control.points.row(v) == cage.points.row(v));
      CHECK(result.vertices[at(v)].correction == Correction::fixed);
    }
    CHECK(corners > 3);
    CHECK(result.errors.position < 1e-12 * 30);
  }

  TEST_CASE("faces that point inward are told and turned over on request") {
    const GoldenMesh mesh = golden_mesh("sphere");
    const Surface<double> inward = flipped(mesh.cage);
    CHECK(std::abs(signed_volume(mesh.cage) + signed_volume(inward)) < 1e-12);
    CHECK(signed_volume(cube<double>()) == doctest::Approx(8));
    CHECK(signed_volume(tetrahedron<double>()) == doctest::Approx(8.0 / 3));
    const Interpolation wrong = interpolate(inward, mesh.normals);
    REQUIRE(wrong.notes.size() == 2);
    CHECK(wrong.notes[0].find("point inward") != std::string::npos);
    CHECK(wrong.notes[1].find("98 vertices: the normal was more than 90 degrees off") != std::string::npos);
    InterpolateOptions options;
    options.flip = true;
    const Interpolation right = interpolate(inward, mesh.normals, options);
    CHECK(right.notes.empty());
    CHECK(right.errors.normal < 1e-12);
    Fan fan;
    collect_fan(*right.control.mesh, 0, fan);
    CHECK(right.vertices[0].angle_before < 0.1);
    Surface<double> tagged = torus<double>(5, 4, 3, 1);
    const Surface<double> turned = flipped(tagged), back = flipped(turned);
    CHECK(faces_of(*back.mesh) == faces_of(*tagged.mesh));
    CHECK(back.tags.edge == tagged.tags.edge);
    int kept = 0;
    const auto length = [](const Surface<double>& s, int e) {
      const int h = s.mesh->edge_half[at(e)];
      return (s.points.row(s.mesh->vertex[at(h)]) - s.points.row(s.mesh->tip(h))).norm();
    };
    for (int e = 0; e < turned.mesh->edges(); ++e)  // longitude edges all have the length 2 r sin(pi/4)
      kept += (turned.tags.edge[at(e)] == EdgeTag::longitude) == (std::abs(length(turned, e) - std::sqrt(2.0)) < 1e-12);
    CHECK(kept == turned.mesh->edges());
  }

  TEST_CASE("normals of the faces around a vertex are their area vectors") {
    const Points<double> normals = area_normals(cube<double>());
    CHECK((normals - 4 * cube<double>().points).cwiseAbs().maxCoeff() < 1e-14);  // three faces of area 4
    Dice dice(87);
    const auto surface = random_surface<double>(dice, *torus<double>(4, 3, 2, 1).mesh);
    Points<double> expected = Points<double>::Zero(12, 3);
    for (int f = 0; f < surface.mesh->faces(); ++f) {
      const auto c = surface.mesh->corners(f);
      const Eigen::RowVector3d a = surface.points.row(c[2]) - surface.points.row(c[0]);
      const Eigen::RowVector3d b = surface.points.row(c[3]) - surface.points.row(c[1]);
      for (const int v : c) expected.row(v) += a.cross(b) / 2;
    }
    CHECK((area_normals(surface) - expected).cwiseAbs().maxCoeff() < 1e-10);
  }

  TEST_CASE("angles are accurate near 0 and near a half turn") {
    const Eigen::RowVector3d x(1, 0, 0);
    CHECK(angle_between(x, Eigen::RowVector3d(5, 5e-9, 0)) == doctest::Approx(1e-9).epsilon(1e-12));
    CHECK(std::acos(-1.0) - angle_between(x, Eigen::RowVector3d(-1, 1e-7, 0)) == doctest::Approx(1e-7).epsilon(1e-6));
    for (const double angle : {1e-12, 1e-9, 1e-7, 1e-3, 1.0, 3.0, 3.14159265, 3.1415926535}) {
      CAPTURE(angle);
      const Eigen::RowVector3d aim(0, std::sin(angle), std::cos(angle));
      const RingTangents tangents{{2, 1, 0}, {-1, 1, 0}};  // their cross product is along z
      const RingTangents change = change_by_turn(tangents, aim);
      const RingTangents turned{tangents.first + change.first, tangents.second + change.second};
      CHECK(angle_between(normal_of(turned), aim) < 1e-15);
      CHECK(std::abs(turned.first.dot(turned.second) - tangents.first.dot(tangents.second)) < 1e-14);
      if (angle < 3.14159) CHECK(std::abs(turned.first[0] - 2) < 1e-7);  // the axis of the smallest turn is x
    }
  }
}
