// Wavefront OBJ output: points, normals, polygons, and the tags as groups corner, lat and lon, which the reader understands.
#include <algorithm>

#include "files/raw_mesh.h"

namespace udcp {
namespace {

/// Lines of three numbers each.
template <class R>
void write_points(Writer& out, std::string_view keyword, std::span<const R> values) {
  for (std::size_t k = 0; k < values.size(); k += 3) {
    char* to = out.room(keyword.size() + 3 * Writer::longest_number + 4);
    to = std::copy(keyword.begin(), keyword.end(), to);
    for (std::size_t c = 0; c < 3; ++c) {
      *to++ = ' ';
      to = put_number(to, values[k + c]);
    }
    *to++ = '\n';
    out.filled(to);
  }
}

/// "f 1 2 3", or with normals "f 1//1 2//2 3//3".
template <class R>
void write_faces(Writer& out, const MeshView<R>& mesh) {
  const std::size_t faces = mesh.faces();
  for (std::size_t f = 0; f < faces; ++f) {
    const auto corners = mesh.face(f);
    char* to = out.room(2 + corners.size() * (2 * 10 + 3));
    *to++ = 'f';
    for (const std::uint32_t v : corners) {
      *to++ = ' ';
      const char* digits = to;
      to = put_number(to, std::uint64_t{v} + 1);
      if (mesh.normals.empty()) continue;
      const char* end = to;
      *to++ = '/';
      *to++ = '/';
      to = std::copy(digits, end, to);
    }
    *to++ = '\n';
    out.filled(to);
  }
}

void write_tags(Writer& out, const Surface<double>& surface) {
  const Mesh& mesh = *surface.mesh;
  bool open = false;
  for (int v = 0; v < mesh.vertices(); ++v) {
    if (!surface.tags.is_corner(v)) continue;
    if (!open) out << "g corner\n";
    open = true;
    out << "p " << v + 1 << '\n';
  }
  for (const EdgeTag tag : {EdgeTag::latitude, EdgeTag::longitude}) {
    open = false;
    for (int e = 0; e < mesh.edges(); ++e) {
      if (surface.tags.of_edge(e) != tag) continue;
      if (!open) out << (tag == EdgeTag::latitude ? "g lat\n" : "g lon\n");
      open = true;
      const int h = mesh.edge_half[Mesh::i(e)];
      out << "l " << mesh.vertex[Mesh::i(h)] + 1 << ' ' << mesh.tip(h) + 1 << '\n';
    }
  }
}

}  // namespace

template <class R>
void write_obj(Writer& out, const MeshView<R>& mesh, const SaveOptions& options) {
  check_for_writing(mesh);
  check_normals(mesh);
  out << "# " << comment_line(options.word) << '\n';
  write_points(out, "v", mesh.points);
  write_points(out, "vn", mesh.normals);
  write_faces(out, mesh);
  if (mesh.surface) write_tags(out, *mesh.surface);
}

std::string write_obj_curve(const Polyline<double>& curve, const SaveOptions& options) {
  validate(curve);
  if (!curve.points.allFinite())
    throw Error(ErrorKind::input, "E_NOT_FINITE", "the curve has a point that is not finite; nothing was written");
  Points<double> points = Points<double>::Zero(curve.points.rows(), 3);
  points.leftCols(curve.points.cols()) = curve.points;
  Writer out(static_cast<std::size_t>(curve.size()) * 70 + 100);
  out << "# " << comment_line(options.word) << '\n';
  write_points(out, "v", std::span<const double>(points.data(), static_cast<std::size_t>(points.size())));
  out << 'l';
  for (int k = 0; k < curve.size(); ++k) out << ' ' << k + 1;
  if (curve.closed) out << " 1";
  out << '\n';
  bool open = false;
  for (int k = 0; k < curve.size(); ++k) {
    if (curve.corner.empty() || curve.corner[static_cast<std::size_t>(k)] == 0) continue;
    if (!open) out << "g corner\n";
    open = true;
    out << "p " << k + 1 << '\n';
  }
  return out.take();
}

template void write_obj(Writer&, const MeshView<float>&, const SaveOptions&);
template void write_obj(Writer&, const MeshView<double>&, const SaveOptions&);

}  // namespace udcp
