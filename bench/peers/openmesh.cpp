// OpenMesh in the comparison: its uniform subdividers on its array kernels, without status bits or other properties.
// --way cold: vertices and faces are added, then the subdivider runs; the result stays in OpenMesh's own structure.
// Loop by LoopT on a triangle mesh, Catmull-Clark by CatmullClarkT on a polygon mesh.
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <memory>

#include "bench/peers/harness.h"

namespace {

using namespace peers;

template <class R>
struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::VectorT<R, 3>;
  using Normal = OpenMesh::VectorT<R, 3>;
  VertexAttributes(0);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(0);
  FaceAttributes(0);
};

template <class M>
std::unique_ptr<M> mesh_of(const Cage& cage) {
  auto mesh = std::make_unique<M>();
  using R = typename M::Scalar;
  const auto vertices = static_cast<std::size_t>(cage.vertices()), faces = static_cast<std::size_t>(cage.faces());
  mesh->reserve(vertices, cage.corners.size() / 2, faces);
  for (std::size_t v = 0; v < vertices; ++v) {
    const double* p = cage.points.data() + 3 * v;
    mesh->add_vertex(typename M::Point(static_cast<R>(p[0]), static_cast<R>(p[1]), static_cast<R>(p[2])));
  }
  std::vector<typename M::VertexHandle> face;
  for (std::size_t f = 0, at = 0; f < faces; ++f) {
    face.clear();
    for (int k = 0; k < cage.sizes[f]; ++k) face.push_back(typename M::VertexHandle(cage.corners[at++]));
    mesh->add_face(face);
  }
  return mesh;
}

template <class M, class Subdivider>
Program cold(const Job& job, const Cage& cage) {
  auto mesh = std::make_shared<std::unique_ptr<M>>();
  Program program;
  program.drop = [mesh] { mesh->reset(); };
  program.run = [mesh, job, &cage] {
    *mesh = mesh_of<M>(cage);
    Subdivider subdivide;
    if (!subdivide(**mesh, static_cast<std::size_t>(job.rounds))) refuse("OpenMesh does not subdivide");
  };
  program.sizes = [mesh, job] {
    return sizes_of(static_cast<std::int64_t>((*mesh)->n_vertices()), static_cast<std::int64_t>((*mesh)->n_faces()), job, true);
  };
  program.result = [mesh] {
    Result result;
    for (const auto v : (*mesh)->vertices())
      for (unsigned k = 0; k < 3; ++k) result.points.push_back(static_cast<double>((*mesh)->point(v)[k]));
    for (const auto f : (*mesh)->faces())
      for (const auto v : (*mesh)->fv_range(f)) result.corners.push_back(static_cast<std::uint32_t>(v.idx()));
    result.corners_per_face = static_cast<int>(result.corners.size() / (*mesh)->n_faces());
    return result;
  };
  return program;
}

template <class R>
Program make_in(const Job& job, const Cage& cage) {
  using Polygons = OpenMesh::PolyMesh_ArrayKernelT<Traits<R>>;
  using Triangles = OpenMesh::TriMesh_ArrayKernelT<Traits<R>>;
  if (job.scheme == "catmull_clark") return cold<Polygons, OpenMesh::Subdivider::Uniform::CatmullClarkT<Polygons, R>>(job, cage);
  if (job.scheme == "loop") return cold<Triangles, OpenMesh::Subdivider::Uniform::LoopT<Triangles, R>>(job, cage);
  refuse("OpenMesh has no scheme " + job.scheme);
}

Program make(const Job& job, const Cage& cage) {
  if (job.way != "cold") refuse("OpenMesh knows the way cold");
  return job.real == "float" ? make_in<float>(job, cage) : make_in<double>(job, cage);
}

}  // namespace

int main(int argc, char** argv) { return run_main(argc, argv, make); }
