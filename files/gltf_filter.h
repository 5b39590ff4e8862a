// What stands between a glTF or GLB file and tinygltf, which trusts what it is given: every file is checked first and reduced to
// the members that are read here. Knows neither tinygltf nor meshes; that accessors lie inside their buffers is checked by the
// reader.
#pragma once

#include <map>
#include <string>

#include "files/scanner.h"

namespace udcp {

/// A file that holds scenes, nodes, primitives and their data only: of bounded depth, with members of the right types. Accessors,
/// views and buffers that no primitive needs have become empty ones, so that all indices are those of the file.
struct FilteredGltf {
  std::string bytes;  // JSON, or a GLB if `binary`
  bool binary = false;
  std::map<std::string, std::string> files;  // the only URIs in `bytes` besides base64 data, and what they stand for
};

/// Throws Error{file} for anything that is no glTF 2.0, for required extensions and sparse accessors, and for buffers that are
/// not there or lie outside the folder of the file.
FilteredGltf filter_gltf(const Input& input);

}  // namespace udcp
