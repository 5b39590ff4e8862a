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
Surface<S> read(const Input& input, const std::string& format) {
  if (format == "obj") return build(read_obj<S>(input), input);
  if (format == "off") return build(read_off<S>(input), input);
  if (format == "ply" || format == "ply-ascii") return build(read_ply<S>(input), input);
  if (format == "stl") return build(read_stl<S>(input), input);
  if (format == "glb" || format == "gltf") return build(read_gltf<S>(input), input);
  fail_format(ErrorKind::file, "E_FILE_FORMAT", input.name, format, read_formats);
}

bool is_gltf(const std::string& format) { return format == "glb" || format == "gltf"; }

}  // namespace

template <class S>
Surface<S> load(const std::filesystem::path& file, Warnings* warnings, const std::string& format) {
  const std::string bytes = read_file(file);
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  return read<S>({bytes, file.string(), warnings, folder}, format_of(file, format));
}

template <class S>
Surface<S> load_bytes(const std::string& bytes, const std::string& format, const std::string& name, Warnings* warnings) {
  return read<S>({bytes, name, warnings, {}}, format_of({}, format));
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

std::string save_bytes(const Surface<double>& surface, const std::string& format, const SaveOptions& options) {
  const std::string name = format_of({}, format);
  if (name == "obj") return write_obj(surface, options);
  if (name == "off") return write_off(surface, options);
  if (name == "ply" || name == "ply-ascii") return write_ply(surface, options, name == "ply");
  if (name == "stl") return write_stl(surface, options);
  if (is_gltf(name)) return write_gltf({{&surface, {}, {0, 0, 0}, options}}, name == "glb");
  fail_format(ErrorKind::input, "E_FORMAT", "cannot save a surface", format, written_formats);
}

void save(const Surface<double>& surface, const std::filesystem::path& file, const SaveOptions& options) {
  const std::string format = format_of(file, options.format);
  if (format.empty()) fail_format(ErrorKind::input, "E_FORMAT", file.string(), format, written_formats);
  write_file(file, save_bytes(surface, format, options));
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
  write_file(file, write_gltf(shapes, format == "glb"));
}

void save_animation(const std::vector<Surface<double>>& frames, const std::filesystem::path& file, const SaveOptions& options,
                    double frames_per_second) {
  const std::string format = format_of(file, options.format);
  if (!is_gltf(format)) fail_format(ErrorKind::input, "E_FORMAT", file.string(), format, "glb and gltf, for animations");
  write_file(file, write_gltf_animation(frames, format == "glb", options, frames_per_second));
}

#define UDCP_LOAD(S)                                                                                        \
  template Surface<S> load<S>(const std::filesystem::path&, Warnings*, const std::string&);                 \
  template Surface<S> load_bytes<S>(const std::string&, const std::string&, const std::string&, Warnings*); \
  template Polyline<S> load_curve<S>(const std::filesystem::path&, Warnings*);                              \
  template Polyline<S> load_curve_bytes<S>(const std::string&, const std::string&, Warnings*);
UDCP_FOR_EACH_COORDINATE(UDCP_LOAD)
#undef UDCP_LOAD

}  // namespace udcp
