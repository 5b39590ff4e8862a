// Which format a file has, and the way in and out through it.
#include "files/geometry_file.h"

#include <algorithm>

#include "files/raw_mesh.h"
#include "files/svg.h"

namespace udcp {
namespace {

std::string format_of(const std::filesystem::path& file, const std::string& format) {
  std::string name = format.empty() ? file.extension().string() : format;
  if (format.empty() && !name.empty()) name.erase(0, 1);
  for (char& c : name) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return name;
}

[[noreturn]] void fail_format(ErrorKind kind, const char* code, const std::string& name, const std::string& format,
                              const char* known) {
  throw Error(kind, code,
              name + (format.empty() ? ": the file name has no extension, so the format is not known"
                                     : ": unknown format '" + format + "'"),
              std::string("known are ") + known);
}

constexpr const char* read_formats = "obj, off, ply, stl, glb and gltf";
constexpr const char* written_formats = "obj, off, ply, ply-ascii, stl, glb and gltf";

template <class S>
RawMesh<S> read(const Input& input, const std::string& format) {
  if (format == "obj") return read_obj<S>(input);
  if (format == "off") return read_off<S>(input);
  if (format == "ply" || format == "ply-ascii") return read_ply<S>(input);
  if (format == "stl") return read_stl<S>(input);
  if (format == "glb" || format == "gltf") return read_gltf<S>(input);
  fail_format(ErrorKind::file, "E_FILE_FORMAT", input.name, format, read_formats);
}

bool is_gltf(const std::string& format) { return format == "glb" || format == "gltf"; }

bool is_mesh_format(const std::string& format) {
  return format == "obj" || format == "off" || format == "ply" || format == "ply-ascii" || format == "stl" || is_gltf(format);
}

}  // namespace

template <class S>
Surface<S> load(const std::filesystem::path& file, Warnings* warnings, const std::string& format) {
  FileBytes bytes = read_bytes(file);
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  Input input{bytes.view(), file.string(), warnings, folder};
  RawMesh<S> raw = read<S>(input, format_of(file, format));
  input.bytes = {};
  bytes = {};  // the memory serves the mesh
  return build(std::move(raw), input);
}

template <class S>
Surface<S> load_bytes(const std::string& bytes, const std::string& format, const std::string& name, Warnings* warnings) {
  const Input input{bytes, name, warnings, {}};
  return build(read<S>(input, format_of({}, format)), input);
}

template <class S>
Polyline<S> load_curve(const std::filesystem::path& file, Warnings* warnings) {
  if (const auto format = format_of(file, {}); format != "obj")
    fail_format(ErrorKind::file, "E_FILE_FORMAT", file.string(), format, "obj, for curves");
  return load_curve_bytes<S>(read_file(file), file.string(), warnings);
}

template <class S>
Polyline<S> load_curve_bytes(const std::string& bytes, const std::string& name, Warnings* warnings) {
  return read_obj_curve<S>({bytes, name, warnings, {}});
}

namespace {

/// The format in which a mesh is written to that file.
std::string mesh_format(const std::filesystem::path& file, const std::string& given) {
  const std::string format = format_of(file, given);
  if (!is_mesh_format(format)) fail_format(ErrorKind::input, "E_FORMAT", file.string(), format, written_formats);
  return format;
}
/// The same for bytes in memory.
std::string mesh_format(const std::string& given) {
  const std::string format = format_of({}, given);
  if (!is_mesh_format(format)) fail_format(ErrorKind::input, "E_FORMAT", "cannot save a surface", given, written_formats);
  return format;
}

template <class R>
void write(Writer& out, const MeshView<R>& mesh, const std::string& format, const SaveOptions& options) {
  if (format == "obj") return write_obj(out, mesh, options);
  if (format == "off") return write_off(out, mesh, options);
  if (format == "stl") return write_stl(out, mesh, options);
  if (is_gltf(format)) return write_gltf(out, mesh, options, format == "glb");
  write_ply(out, mesh, options, format == "ply");
}

/// About as many bytes as the mesh will take: so much memory is reserved.
template <class R>
std::size_t expected_size(const MeshView<R>& mesh) {
  return 200 + 25 * mesh.points.size() + 10 * mesh.corners.size();
}

}  // namespace

std::string save_bytes(const Surface<double>& surface, const std::string& given, const SaveOptions& options) {
  const std::string format = mesh_format(given);
  Points<double> padded;
  const MeshView<double> mesh = view_of(surface, options, padded);
  Writer out(expected_size(mesh), options.stop);
  write(out, mesh, format, options);
  return out.take();
}

void save(const Surface<double>& surface, const std::filesystem::path& file, const SaveOptions& options) {
  const std::string format = mesh_format(file, options.format);
  Points<double> padded;
  Writer out(file, options.stop);
  write(out, view_of(surface, options, padded), format, options);
  out.commit();
}

template <class R>
std::string save_bytes(const FlatMesh<R>& flat, const std::string& given, const SaveOptions& options) {
  const std::string format = mesh_format(given);
  const MeshView<R> mesh = view_of(flat, options);
  Writer out(expected_size(mesh), options.stop);
  write(out, mesh, format, options);
  return out.take();
}

template <class R>
void save(const FlatMesh<R>& mesh, const std::filesystem::path& file, const SaveOptions& options) {
  const std::string format = mesh_format(file, options.format);
  Writer out(file, options.stop);
  write(out, view_of(mesh, options), format, options);
  out.commit();
}

std::string save_bytes(const Polyline<double>& curve, const std::string& format, const SaveOptions& options) {
  const std::string name = format_of({}, format);
  if (name == "obj") return write_obj_curve(curve, options);
  if (name == "svg") return svg_curve(curve);
  fail_format(ErrorKind::input, "E_FORMAT", "cannot save a curve", format, "obj and svg");
}

void save(const Polyline<double>& curve, const std::filesystem::path& file, const SaveOptions& options) {
  const std::string format = format_of(file, options.format);
  if (format.empty()) fail_format(ErrorKind::input, "E_FORMAT", file.string(), format, "obj and svg");
  write_file(file, save_bytes(curve, format, options));
}

void save_scene(const std::vector<SceneShape>& shapes, const std::filesystem::path& file) {
  const std::string format = format_of(file, {});
  if (!is_gltf(format))
    fail_format(ErrorKind::input, "E_FORMAT", file.string(), format, "glb and gltf, for several shapes in one file");
  Writer out(file);
  write_gltf(out, shapes, format == "glb");
  out.commit();
}

void save_animation(const std::vector<Surface<double>>& frames, const std::filesystem::path& file, const SaveOptions& options,
                    double frames_per_second) {
  const std::string format = format_of(file, options.format);
  if (!is_gltf(format)) fail_format(ErrorKind::input, "E_FORMAT", file.string(), format, "glb and gltf, for animations");
  Writer out(file, options.stop);
  write_gltf_animation(out, frames, format == "glb", options, frames_per_second);
  out.commit();
}

#define UDCP_SAVE(R)                                                                        \
  template void save(const FlatMesh<R>&, const std::filesystem::path&, const SaveOptions&); \
  template std::string save_bytes(const FlatMesh<R>&, const std::string&, const SaveOptions&);
UDCP_SAVE(float)
UDCP_SAVE(double)
#undef UDCP_SAVE

#define UDCP_LOAD(S)                                                                                        \
  template Surface<S> load<S>(const std::filesystem::path&, Warnings*, const std::string&);                 \
  template Surface<S> load_bytes<S>(const std::string&, const std::string&, const std::string&, Warnings*); \
  template Polyline<S> load_curve<S>(const std::filesystem::path&, Warnings*);                              \
  template Polyline<S> load_curve_bytes<S>(const std::string&, const std::string&, Warnings*);
UDCP_FOR_EACH_COORDINATE(UDCP_LOAD)
#undef UDCP_LOAD

}  // namespace udcp
