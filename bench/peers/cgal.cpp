// CGAL in the comparison: Subdivision_method_3 on a mesh whose kernel has plain float or double coordinates.
// --way cold: vertices and faces are added to a Surface_mesh, then subdivided; the result stays in it.
//       polyhedron: the same in a Polyhedron_3, CGAL's older container of linked half-edges.
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/subdivision_method_3.h>

#include <memory>
#include <unordered_map>

#include "bench/peers/harness.h"

namespace {

using namespace peers;

template <class M, class Point>
std::unique_ptr<M> mesh_of(const Cage& cage) {
  auto mesh = std::make_unique<M>();
  using Vertex = typename boost::graph_traits<M>::vertex_descriptor;
  auto point = get(CGAL::vertex_point, *mesh);
  std::vector<Vertex> vertices, face;
  using R = std::decay_t<decltype(std::declval<Point>().x())>;
  for (std::size_t v = 0; v < static_cast<std::size_t>(cage.vertices()); ++v) {
    const double* p = cage.points.data() + 3 * v;
    vertices.push_back(add_vertex(*mesh));
    put(point, vertices.back(), Point(static_cast<R>(p[0]), static_cast<R>(p[1]), static_cast<R>(p[2])));
  }
  std::size_t at = 0;
  for (const int size : cage.sizes) {
    face.clear();
    for (int k = 0; k < size; ++k) face.push_back(vertices[static_cast<std::size_t>(cage.corners[at++])]);
    CGAL::Euler::add_face(face, *mesh);
  }
  return mesh;
}

template <class M>
Result result_of(const M& mesh) {
  Result result;
  std::unordered_map<typename boost::graph_traits<M>::vertex_descriptor, std::uint32_t> index;
  const auto point = get(CGAL::vertex_point, mesh);
  for (const auto v : vertices(mesh)) {
    index.emplace(v, static_cast<std::uint32_t>(index.size()));
    const auto p = get(point, v);
    for (const auto c : {p.x(), p.y(), p.z()}) result.points.push_back(static_cast<double>(c));
  }
  for (const auto f : faces(mesh))
    for (const auto v : vertices_around_face(halfedge(f, mesh), mesh)) result.corners.push_back(index.at(v));
  result.corners_per_face = static_cast<int>(result.corners.size() / num_faces(mesh));
  return result;
}

template <class M, class Point>
Program cold(const Job& job, const Cage& cage) {
  auto mesh = std::make_shared<std::unique_ptr<M>>();
  Program program;
  program.drop = [mesh] { mesh->reset(); };
  program.run = [mesh, job, &cage] {
    *mesh = mesh_of<M, Point>(cage);
    const auto rounds = CGAL::parameters::number_of_iterations(static_cast<unsigned>(job.rounds));
    if (job.scheme == "catmull_clark")
      CGAL::Subdivision_method_3::CatmullClark_subdivision(**mesh, rounds);
    else if (job.scheme == "loop")
      CGAL::Subdivision_method_3::Loop_subdivision(**mesh, rounds);
    else
      refuse("CGAL has no scheme " + job.scheme);
  };
  program.sizes = [mesh, job] {
    return sizes_of(static_cast<std::int64_t>(num_vertices(**mesh)), static_cast<std::int64_t>(num_faces(**mesh)), job, true);
  };
  program.result = [mesh] { return result_of(**mesh); };
  return program;
}

template <class R>
Program make_in(const Job& job, const Cage& cage) {
  using Kernel = CGAL::Simple_cartesian<R>;
  using Point = typename Kernel::Point_3;
  if (job.way == "cold") return cold<CGAL::Surface_mesh<Point>, Point>(job, cage);
  if (job.way == "polyhedron") return cold<CGAL::Polyhedron_3<Kernel>, Point>(job, cage);
  refuse("CGAL knows the ways cold and polyhedron");
}

Program make(const Job& job, const Cage& cage) {
  return job.real == "float" ? make_in<float>(job, cage) : make_in<double>(job, cage);
}

}  // namespace

int main(int argc, char** argv) { return run_main(argc, argv, make); }
