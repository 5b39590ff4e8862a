// Tangents and normals: their side, mirrors, and at boundaries the limit of the face normals under repeated refinement.
#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include "operators/limit.h"
#include "operators/neighbourhood.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/obj_lines.h"
#include "tests/oracle/schemes.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

Surface<double> mirrored(const Surface<double>& surface) {
  Faces faces = faces_of(*surface.mesh);
  for (auto& face : faces) std::reverse(face.begin(), face.end());
  Surface<double> result{std::make_shared<const Mesh>(make_mesh(surface.mesh->vertices(), faces)), surface.points, {}, {}};
  result.points.col(0) *= -1;
  return result;
}

// Normals of the faces at the centre of a small piece of surface.
std::vector<Eigen::Vector3d> face_normals(const Surface<double>& piece) {
  std::vector<Eigen::Vector3d> result;
  const Mesh& mesh = *piece.mesh;
  for (int h = mesh.outgoing[0]; h >= 0; h = mesh.around(h)) {
    const Eigen::Vector3d v = piece.points.row(0), a = piece.points.row(mesh.tip(h)),
                          b = piece.points.row(mesh.vertex[Mesh::i(mesh.prev(h))]);
    result.push_back((a - v).cross(b - v).normalized());
    if (mesh.around(h) == mesh.outgoing[0]) break;
  }
  return result;
}

// Refines the rings round vertex v again and again, blowing up what is left: its shape tends to that of the surface there.
Surface<double> zoom(const Word& word, const Surface<double>& surface, int v, int rounds) {
  constexpr int rings = 3;
  const auto piece_at = [&](const Surface<double>& from, int centre) {
    Neighbourhood local = neighbourhood(*from.mesh, from.tags, from.mesh->outgoing[Mesh::i(centre)], rings);
    Surface<double> piece{std::make_shared<const Mesh>(local.mesh),
                          Points<double>(static_cast<Eigen::Index>(local.vertex.size()), 3),
                          local.tags,
                          {}};
    for (std::size_t k = 0; k < local.vertex.size(); ++k)
      piece.points.row(static_cast<Eigen::Index>(k)) = from.points.row(local.vertex[k]);
    return piece;
  };
  Surface<double> piece = piece_at(surface, v);
  for (int round = 0; round < rounds; ++round) {
    piece = piece_at(run(word, piece, 1), 0);
    // on the boundary, a cubic spline: its limit is (a + 4 v + b)/6
    const Mesh& mesh = *piece.mesh;
    const int ahead = mesh.tip(mesh.outgoing[0]), behind = mesh.vertex[Mesh::i(mesh.boundary_arrival(0))];
    const Eigen::RowVector3d limit_point = (piece.points.row(ahead) + 4 * piece.points.row(0) + piece.points.row(behind)) / 6;
    piece.points.rowwise() -= limit_point;
    piece.points /= piece.points.rowwise().norm().maxCoeff();
  }
  return piece;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("normals are unit vectors across the tangents and point outward on closed shapes") {
    for (const Word& word : {catmull_clark(), scheme("UDD"), scheme("UCP", nullptr, value(1, 2), value(1, 2))}) {
      const auto box = cube<double>();
      const Limit at_box = limit(word, box);
      const auto ring = torus<double>(7, 5, 3, 1);
      const Limit at_ring = limit(word, ring);
      for (int v = 0; v < 8; ++v) CHECK(at_box.normals.row(v).dot(box.points.row(v)) > 0.9 * box.points.row(v).norm());
      for (Eigen::Index v = 0; v < at_ring.normals.rows(); ++v) {
        Eigen::RowVector3d axis = ring.points.row(v);
        axis[2] = 0;
        const Eigen::RowVector3d outward = ring.points.row(v) - 3 * axis.normalized();
        CHECK(at_ring.normals.row(v).dot(outward) > 0.8);
      }
      for (const Limit* found : {&at_box, &at_ring}) {
        CHECK((found->normals.rowwise().norm().array() - 1).abs().maxCoeff() < 1e-12);
        for (Eigen::Index v = 0; v < found->normals.rows(); ++v) {
          const Eigen::RowVector3d a = found->tangents.row(v).head<3>(), b = found->tangents.row(v).tail<3>(),
                                   n = found->normals.row(v);
          CHECK(std::abs(a.dot(n)) < 1e-12 * (1 + a.norm()));
          CHECK(std::abs(b.dot(n)) < 1e-12 * (1 + b.norm()));
          CHECK(a.cross(b).dot(n) > 0);
        }
      }
    }
  }

  TEST_CASE("loop normals of a sphere-like solid point outward") {
    for (const auto& solid : {octahedron<double>(), icosahedron<double>(), tetrahedron<double>()}) {
      const Limit found = limit(loop(), solid);
      for (Eigen::Index v = 0; v < found.normals.rows(); ++v)
        CHECK(found.normals.row(v).dot(solid.points.row(v).normalized()) > 1 - 1e-9);
    }
  }

  TEST_CASE("mirrored meshes have mirrored limits and normals") {
    Dice dice(151);
    for (const Mesh& mesh : {prism(5), *cube<Rational>().mesh, l_shape(), *ring_mesh(6, 1).mesh, *ring_mesh(3, 1).mesh}) {
      const auto surface = random_surface<double>(dice, mesh);
      const Limit a = limit(catmull_clark(), surface), b = limit(catmull_clark(), mirrored(surface));
      Points<double> points = a.points, normals = a.normals;
      points.col(0) *= -1;
      normals.col(0) *= -1;
      CHECK((points - b.points).cwiseAbs().maxCoeff() < 1e-9);
      CHECK((normals - b.normals).cwiseAbs().maxCoeff() < 1e-7);
    }
  }

  TEST_CASE("a flat mesh has the normal of its plane everywhere") {
    for (const auto& flat : {ring_mesh(3, 2), ring_mesh(5, 2), ring_mesh(9, 2)}) {
      const Limit found = limit(catmull_clark(), flat);
      for (Eigen::Index v = 0; v < found.normals.rows(); ++v)
        CHECK((found.normals.row(v) - Eigen::RowVector3d(0, 0, 1)).norm() < 1e-9);
    }
    const Limit found = limit(loop(), ring_mesh(7, 2, true));
    for (Eigen::Index v = 0; v < found.normals.rows(); ++v)
      CHECK((found.normals.row(v) - Eigen::RowVector3d(0, 0, 1)).norm() < 1e-9);
  }

  TEST_CASE("on a smooth boundary the normal is the limit of the face normals also at a reflex corner") {
    const auto l = as_surface(read_obj_lines(UDCP_TEST_DATA "/reference/l_shape.obj"));
    const Limit found = limit(catmull_clark(), l);
    int reflex = 0;
    for (int v = 0; v < l.mesh->vertices(); ++v) {
      if (!l.mesh->on_boundary(v)) continue;
      CAPTURE(v);
      reflex += l.mesh->valence(v) == 4;
      // at a vertex of one face that face gets half as wide with every round: 60 rounds would leave only rounding errors
      const bool one_face = l.mesh->valence(v) == 2;
      for (const Eigen::Vector3d& normal : face_normals(zoom(catmull_clark(), l, v, one_face ? 20 : 60)))
        CHECK((normal - found.normals.row(v).transpose()).norm() < (one_face ? 1e-5 : 1e-6));
    }
    CHECK(reflex == 1);
  }
}
