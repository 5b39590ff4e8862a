// What every fuzz target of a file format does: read, and if that works, write and read again, which must give the same mesh.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>

#include "files/geometry_file.h"

namespace udcp {

/// Aborts on an internal error, or when a mesh does not come back as it was (`same`: in every bit; STL and glTF round to float).
inline int round_trip(const std::uint8_t* data, std::size_t size, const char* format, bool same) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    Warnings warnings;
    const Surface<double> first = load_bytes<double>(bytes, format, "fuzz", &warnings);
    validate(first);
    if (!same && !(first.points.cwiseAbs().maxCoeff() < 1e30)) return 0;
    const std::string written = save_bytes(first, format);
    if (!same) return 0;
    const Surface<double> second = load_bytes<double>(written, format, "fuzz");
    if (second.points != first.points || second.mesh->vertex != first.mesh->vertex ||
        second.mesh->face_begin != first.mesh->face_begin)
      std::abort();
    for (int e = 0; e < first.mesh->edges(); ++e) {
      if (second.tags.of_edge(e) != first.tags.of_edge(e)) std::abort();
    }
    for (int v = 0; v < first.mesh->vertices(); ++v) {
      if (second.tags.is_corner(v) != first.tags.is_corner(v)) std::abort();
    }
  } catch (const Error& error) {
    if (error.kind == ErrorKind::internal) std::abort();
  }
  return 0;
}

}  // namespace udcp
