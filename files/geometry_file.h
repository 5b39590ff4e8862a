// Loading and saving meshes and curves by file extension; strict readers, atomic writers. operators < files: no language here.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "operators/polyline.h"
#include "operators/surface.h"

namespace udcp {

template <class R>
struct FlatMesh;  // operators/plan/flat_mesh.h

/// What a reader noticed and went on after: "cage.obj:7: unknown keyword 'foo'; ignored".
using Warnings = std::vector<std::string>;
/// Whether a warning of load says that it dropped vertices without faces, for those to whom that is an error.
bool says_unused(const std::string& warning);

/// Extension (or `format` if not empty: "obj", "off", "ply", "stl", "glb", "gltf") decides. Decimals become exact in S = Rational
/// (a binary float is the dyadic number that it is); double rounds to nearest. Throws Error{file} with code, the file, the line
/// or byte, the element and what was expected: E_FILE_OPEN, E_FILE_FORMAT, E_FILE_SYNTAX, E_FILE_NUMBER, E_FILE_INDEX,
/// E_FILE_COUNT, E_FILE_EMPTY, E_FILE_TAG, E_FILE_TOO_LARGE, and the codes of make_mesh with kind `input` and the file named.
/// Vertices that no face uses are dropped with a warning. STL and glTF repeat points: bit-identical ones become one vertex.
/// Attributes: PLY vertex properties beyond x y z, and per-vertex normals (OBJ vn, NOFF, PLY nx ny nz, glTF NORMAL) as nx, ny, nz
/// where each vertex has one normal. Every number type is instantiated.
template <class S>
Surface<S> load(const std::filesystem::path& file, Warnings* warnings = nullptr, const std::string& format = {});

/// Same, from bytes in memory; `name` stands for the file in messages. For standard input, tests and fuzzing.
template <class S>
Surface<S> load_bytes(const std::string& bytes, const std::string& format, const std::string& name, Warnings* warnings = nullptr);

/// A curve from an OBJ file with `v` lines and one `l` line, closed if its last index is the first. Errors as for load.
template <class S>
Polyline<S> load_curve(const std::filesystem::path& file, Warnings* warnings = nullptr);
template <class S>
Polyline<S> load_curve_bytes(const std::string& bytes, const std::string& name, Warnings* warnings = nullptr);

struct SaveOptions {
  std::string word;                               // glTF extras; comment line in text formats
  std::map<std::string, std::string> parameters;  // glTF extras
  std::string colour_attribute;                   // scalar attribute shown as COLOR_0 (glTF only)
  bool zero_matters = false;                      // of that attribute: values that are not positive are red
  const Points<double>* normals = nullptr;  // unit normals per vertex (OBJ, PLY, glTF); null: area-weighted ones (glTF only)
  std::string format;                       // empty: by extension. "ply-ascii" besides the names of load
  const std::atomic<bool>* stop = nullptr;  // set: writing a mesh ends with E_INTERRUPTED, and the file is as it was
};
/// OBJ (tags as groups corner, lat, lon), PLY (binary, with attributes), OFF, STL, glTF/GLB (triangles, float). Text numbers
/// round-trip. The file appears as with write_file, but is written piece by piece and never lies in memory. Throws Error{input}:
/// E_FORMAT (unknown extension), E_NOT_FINITE naming the vertex, E_FLOAT_RANGE (a coordinate does not fit the floats of STL and
/// glTF), E_ATTRIBUTE (no such colour attribute), E_POINTS (normals that do not fit), and what validate throws;
/// Error{limit, "E_TOO_LARGE"} for more than the format can count (glTF: 4 GiB). All of it before the file is touched.
void save(const Surface<double>& surface, const std::filesystem::path& file, const SaveOptions& options = {});
std::string save_bytes(const Surface<double>& surface, const std::string& format, const SaveOptions& options = {});

/// The same for a flat mesh of floats or doubles, whose arrays go to the file as they are where the format allows it (GLB and PLY
/// from floats). Its normals are those of the mesh (OBJ, PLY, glTF). Besides: E_NO_FACES, E_FACE_SIZE, E_POINTS where its arrays
/// do not fit each other, E_INDEX for a corner beyond the vertices. OFF holds 0 for the number of edges, which is not known.
template <class R>
void save(const FlatMesh<R>& mesh, const std::filesystem::path& file, const SaveOptions& options = {});
template <class R>
std::string save_bytes(const FlatMesh<R>& mesh, const std::string& format, const SaveOptions& options = {});

/// A curve as OBJ (`l` line) or SVG (a picture).
void save(const Polyline<double>& curve, const std::filesystem::path& file, const SaveOptions& options = {});
std::string save_bytes(const Polyline<double>& curve, const std::string& format, const SaveOptions& options = {});

/// Several shapes in one glTF/GLB file, each a node of its own.
struct SceneShape {
  const Surface<double>* surface = nullptr;
  std::string name;
  std::array<double, 3> place{0, 0, 0};  // translation
  SaveOptions options;                   // word, parameters, colours and normals of this shape
};
void save_scene(const std::vector<SceneShape>& shapes, const std::filesystem::path& file);

/// Frames as morph targets with an animation of their weights; glTF/GLB only. Throws Error{input, "E_ANIMATION"} without frames,
/// or naming the first frame whose connectivity is not that of frame 0.
void save_animation(const std::vector<Surface<double>>& frames, const std::filesystem::path& file,
                    const SaveOptions& options = {}, double frames_per_second = 24);

/// Writes to a temporary file in the same folder, flushes it to the disk and renames it over `file`; on any error `file` is as it
/// was, no temporary is left, and Error{file, "E_FILE_WRITE"} is thrown. Symbolic links are followed, the mode of an existing
/// file stays; what is no regular file (a device, a pipe) is written directly.
void write_file(const std::filesystem::path& file, const std::string& bytes);
/// Whole file; Error{file, "E_FILE_OPEN"} if it cannot be read, E_FILE_TOO_LARGE above `limit` bytes.
std::string read_file(const std::filesystem::path& file, std::uintmax_t limit = std::uintmax_t{1} << 32);

}  // namespace udcp
