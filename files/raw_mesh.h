// Between the readers and Surface: the lists that a file holds, and the one place that turns them into a checked mesh. Also the
// entry points of the formats.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "files/mesh_view.h"
#include "files/scanner.h"
#include "operators/surface.h"

namespace udcp {

/// A tag that a file puts on an element, with the line to blame.
struct TaggedEdge {
  int from, to;
  EdgeTag tag;
  std::int64_t line;
};
struct TaggedVertex {
  int vertex;
  std::int64_t line;
};

template <class S>
struct RawMesh {
  std::vector<S> coordinates;                        // three per vertex
  std::vector<int> begin{0}, corners;                // as for make_mesh
  std::vector<std::uint32_t> face_lines;             // per face; empty where there are no lines
  std::map<std::string, std::vector<S>> attributes;  // per vertex
  std::vector<TaggedEdge> edges;
  std::vector<TaggedVertex> tagged_corners;
  int first_index = 0;  // how the format counts, for messages

  [[nodiscard]] int vertices() const { return static_cast<int>(coordinates.size() / 3); }
  [[nodiscard]] int faces() const { return static_cast<int>(begin.size()) - 1; }
  void close_face(std::int64_t line) {
    begin.push_back(static_cast<int>(corners.size()));
    if (line > 0) face_lines.push_back(static_cast<std::uint32_t>(line));
  }
};

/// Checks everything, drops unused vertices with a warning, warns of what is legal but strange (faces without area, crossed
/// quads, coincident vertices on a boundary, interior vertices of valence 2). Throws the errors of make_mesh with file and line.
template <class S>
Surface<S> build(RawMesh<S> raw, const Input& input);

/// Error{file, "E_FILE_TOO_LARGE"} when a list of the file passes what an int can count.
void expect_int_count(const Input& input, std::size_t count, const char* what);

/// Makes one vertex of all bit-identical points (0 and -0 are the same): for each point the index of its vertex, vertices in
/// order of first appearance. `kept` lists the first point of each vertex.
std::vector<int> weld(const std::vector<double>& coordinates, std::vector<int>& kept);

template <class S>
RawMesh<S> read_obj(const Input& input);
template <class S>
RawMesh<S> read_off(const Input& input);
template <class S>
RawMesh<S> read_ply(const Input& input);
template <class S>
RawMesh<S> read_stl(const Input& input);
template <class S>
RawMesh<S> read_gltf(const Input& input);  // .gltf or .glb
template <class S>
Polyline<S> read_obj_curve(const Input& input);

std::string write_obj_curve(const Polyline<double>& curve, const SaveOptions& options);
/// R = float or double. Everything that can be wrong with the mesh is thrown before the first byte is written.
template <class R>
void write_obj(Writer& out, const MeshView<R>& mesh, const SaveOptions& options);
template <class R>
void write_off(Writer& out, const MeshView<R>& mesh, const SaveOptions& options);
template <class R>
void write_ply(Writer& out, const MeshView<R>& mesh, const SaveOptions& options, bool binary);
template <class R>
void write_stl(Writer& out, const MeshView<R>& mesh, const SaveOptions& options);
template <class R>
void write_gltf(Writer& out, const MeshView<R>& mesh, const SaveOptions& options, bool binary);
void write_gltf(Writer& out, const std::vector<SceneShape>& shapes, bool binary);
void write_gltf_animation(Writer& out, const std::vector<Surface<double>>& frames, bool binary, const SaveOptions& options,
                          double frames_per_second);

}  // namespace udcp
