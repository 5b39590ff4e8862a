// PLY output: coordinates and normals in the numbers of the mesh, attributes as doubles, n-gons as lists; binary little endian or
// ascii.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>

#include "files/raw_mesh.h"

namespace udcp {
namespace {

/// Property names are single words.
std::string property_name(const std::string& name) {
  std::string result;
  for (const char c : name) result += c > ' ' && c <= '~' ? c : '_';
  return result.empty() || result == "x" || result == "y" || result == "z" ? "attribute_" + result : result;
}

/// The columns beside x, y and z.
template <class R>
struct Columns {
  std::span<const R> normals;
  std::vector<std::pair<std::string, std::span<const double>>> attributes;

  explicit Columns(const MeshView<R>& mesh) {
    if (mesh.surface) {
      for (const auto& [name, values] : mesh.surface->attributes) attributes.emplace_back(property_name(name), values);
    }
    const auto named = [](const auto& attribute) {
      return attribute.first == "nx" || attribute.first == "ny" || attribute.first == "nz";
    };
    if (std::ranges::none_of(attributes, named)) normals = mesh.normals;
  }
  [[nodiscard]] bool empty() const { return normals.empty() && attributes.empty(); }
};

template <class R>
void write_header(Writer& out, const MeshView<R>& mesh, const Columns<R>& columns, const SaveOptions& options, bool binary,
                  bool long_faces) {
  const char* number = std::is_same_v<R, float> ? "float" : "double";
  out << "ply\nformat " << (binary ? "binary_little_endian" : "ascii") << " 1.0\ncomment " << comment_line(options.word) << '\n';
  out << "element vertex " << mesh.vertices() << '\n';
  for (const char* name : {"x", "y", "z"}) out << "property " << number << ' ' << name << '\n';
  if (!columns.normals.empty()) {
    for (const char* name : {"nx", "ny", "nz"}) out << "property " << number << ' ' << name << '\n';
  }
  for (const auto& [name, values] : columns.attributes) out << "property double " << name << '\n';
  out << "element face " << mesh.faces() << "\nproperty list " << (long_faces ? "int" : "uchar");
  out << " int vertex_indices\nend_header\n";
}

template <class R>
void write_binary(Writer& out, const MeshView<R>& mesh, const Columns<R>& columns, bool long_faces) {
  if (columns.empty()) {
    out.write(mesh.points);
  } else {
    const std::size_t numbers = columns.normals.empty() ? 3 : 6;
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
      char* to = out.room(numbers * sizeof(R) + columns.attributes.size() * sizeof(double));
      for (std::size_t c = 0; c < 3; ++c) to = put_bytes(to, mesh.points[3 * v + c]);
      for (std::size_t c = 0; c + 3 < numbers; ++c) to = put_bytes(to, columns.normals[3 * v + c]);
      for (const auto& [name, values] : columns.attributes) to = put_bytes(to, values[v]);
      out.filled(to);
    }
  }
  const std::size_t faces = mesh.faces();
  for (std::size_t f = 0; f < faces; ++f) {
    const auto corners = mesh.face(f);
    char* to = out.room(4 + corners.size_bytes());
    const auto size = static_cast<std::uint32_t>(corners.size());
    to = long_faces ? put_bytes(to, size) : put_bytes(to, static_cast<std::uint8_t>(size));
    if (size == 4) {  // a copy of known length is an instruction or two
      std::memcpy(to, corners.data(), 16);
    } else {
      std::memcpy(to, corners.data(), corners.size_bytes());
    }
    out.filled(to + corners.size_bytes());
  }
}

template <class R>
void write_text(Writer& out, const MeshView<R>& mesh, const Columns<R>& columns) {
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    for (std::size_t c = 0; c < 3; ++c) out << (c > 0 ? " " : "") << mesh.points[3 * v + c];
    for (std::size_t c = 0; c < 3 && !columns.normals.empty(); ++c) out << ' ' << columns.normals[3 * v + c];
    for (const auto& [name, values] : columns.attributes) out << ' ' << values[v];
    out << '\n';
  }
  const std::size_t faces = mesh.faces();
  for (std::size_t f = 0; f < faces; ++f) {
    out << mesh.face(f).size();
    for (const std::uint32_t v : mesh.face(f)) out << ' ' << v;
    out << '\n';
  }
}

}  // namespace

template <class R>
void write_ply(Writer& out, const MeshView<R>& mesh, const SaveOptions& options, bool binary) {
  if (mesh.vertices() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    throw Error(ErrorKind::limit, "E_TOO_LARGE", "a PLY file with indices of type int cannot hold more than 2^31 - 1 vertices",
                "refine less");
  }
  check_for_writing(mesh);
  const Columns<R> columns(mesh);
  if (!columns.normals.empty()) check_normals(mesh);
  bool long_faces = mesh.sides > 255;
  for (std::size_t f = 1; f < mesh.begin.size(); ++f) long_faces = long_faces || mesh.begin[f] - mesh.begin[f - 1] > 255;
  write_header(out, mesh, columns, options, binary, long_faces);
  if (binary) {
    write_binary(out, mesh, columns, long_faces);
  } else {
    write_text(out, mesh, columns);
  }
}

template void write_ply(Writer&, const MeshView<float>&, const SaveOptions&, bool);
template void write_ply(Writer&, const MeshView<double>&, const SaveOptions&, bool);

}  // namespace udcp
