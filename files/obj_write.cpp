// Wavefront OBJ output: points, normals, polygons, and the tags as groups corner, lat and lon, which the reader understands.
#include "files/raw_mesh.h"
#include "files/text_writer.h"

namespace udcp {
namespace {

void write_points(TextWriter& out, const char* keyword, const Points<double>& points) {
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    out << keyword;
    for (Eigen::Index c = 0; c < 3; ++c) out << ' ' << coordinate(points, v, c);
    out << '\n';
  }
}

void write_tags(TextWriter& out, const Surface<double>& surface) {
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

std::string write_obj(const Surface<double>& surface, const SaveOptions& options) {
  check_for_writing(surface);
  const Mesh& mesh = *surface.mesh;
  TextWriter out(static_cast<std::size_t>(mesh.vertices()) * 60 + static_cast<std::size_t>(mesh.half_edges()) * 9 + 100);
  out << "# " << comment_line(options.word) << '\n';
  write_points(out, "v", surface.points);
  if (options.normals) write_points(out, "vn", *options.normals);
  for (int f = 0; f < mesh.faces(); ++f) {
    out << 'f';
    for (const int v : mesh.corners(f)) {
      out << ' ' << v + 1;
      if (options.normals) out << "//" << v + 1;
    }
    out << '\n';
  }
  write_tags(out, surface);
  return out.take();
}

std::string write_obj_curve(const Polyline<double>& curve, const SaveOptions& options) {
  validate(curve);
  if (!curve.points.allFinite())
    throw Error(ErrorKind::input, "E_NOT_FINITE", "the curve has a point that is not finite; nothing was written");
  TextWriter out(static_cast<std::size_t>(curve.size()) * 70 + 100);
  out << "# " << comment_line(options.word) << '\n';
  write_points(out, "v", curve.points);
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

}  // namespace udcp
