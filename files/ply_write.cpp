// PLY output: coordinates and attributes as doubles, n-gons as lists; binary little endian or ascii.
#include <bit>
#include <cstdint>

#include "files/raw_mesh.h"
#include "files/text_writer.h"

namespace udcp {
namespace {

/// Property names are single words.
std::string property_name(const std::string& name) {
  std::string result;
  for (const char c : name) result += c > ' ' && c <= '~' ? c : '_';
  return result.empty() || result == "x" || result == "y" || result == "z" ? "attribute_" + result : result;
}

std::string header(const Surface<double>& surface, const SaveOptions& options, bool binary, const char* length_type) {
  TextWriter out(400);
  out << "ply\nformat " << (binary ? "binary_little_endian" : "ascii") << " 1.0\ncomment " << comment_line(options.word) << '\n';
  out << "element vertex " << surface.mesh->vertices() << "\nproperty double x\nproperty double y\nproperty double z\n";
  for (const auto& [name, values] : surface.attributes) out << "property double " << property_name(name) << '\n';
  out << "element face " << surface.mesh->faces() << "\nproperty list " << length_type << " int vertex_indices\nend_header\n";
  return out.take();
}

template <class Unsigned>
void put(std::string& bytes, Unsigned value) {
  for (std::size_t k = 0; k < sizeof value; ++k) bytes.push_back(static_cast<char>(value >> (8 * k) & 0xff));
}

}  // namespace

std::string write_ply(const Surface<double>& surface, const SaveOptions& options, bool binary) {
  check_for_writing(surface);
  const Mesh& mesh = *surface.mesh;
  bool long_faces = false;
  for (int f = 0; f < mesh.faces(); ++f) long_faces = long_faces || mesh.size(f) > 255;
  const std::string head = header(surface, options, binary, long_faces ? "int" : "uchar");
  const std::size_t columns = 3 + surface.attributes.size();
  if (binary) {
    std::string out = head;
    out.reserve(head.size() + Mesh::i(mesh.vertices()) * columns * 8 + Mesh::i(mesh.faces() + mesh.half_edges()) * 4);
    for (int v = 0; v < mesh.vertices(); ++v) {
      for (Eigen::Index c = 0; c < 3; ++c) put(out, std::bit_cast<std::uint64_t>(coordinate(surface.points, v, c)));
      for (const auto& [name, values] : surface.attributes) put(out, std::bit_cast<std::uint64_t>(values[Mesh::i(v)]));
    }
    for (int f = 0; f < mesh.faces(); ++f) {
      if (long_faces) {
        put(out, static_cast<std::uint32_t>(mesh.size(f)));
      } else {
        put(out, static_cast<std::uint8_t>(mesh.size(f)));
      }
      for (const int v : mesh.corners(f)) put(out, static_cast<std::uint32_t>(v));
    }
    return out;
  }
  TextWriter out(head.size() + Mesh::i(mesh.vertices()) * columns * 20 + Mesh::i(mesh.half_edges()) * 9);
  out << head;
  for (int v = 0; v < mesh.vertices(); ++v) {
    for (Eigen::Index c = 0; c < 3; ++c) out << (c > 0 ? " " : "") << coordinate(surface.points, v, c);
    for (const auto& [name, values] : surface.attributes) out << ' ' << values[Mesh::i(v)];
    out << '\n';
  }
  for (int f = 0; f < mesh.faces(); ++f) {
    out << mesh.size(f);
    for (const int v : mesh.corners(f)) out << ' ' << v;
    out << '\n';
  }
  return out.take();
}

}  // namespace udcp
