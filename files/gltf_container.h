// The two containers of glTF: a JSON text on its own, and the GLB that holds it with one binary chunk. Knows nothing of what the
// JSON says.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "files/scanner.h"
#include "files/writer.h"

namespace udcp {

/// Parts of the input; every length has been checked.
struct GltfContainer {
  std::string_view json;
  std::optional<std::string_view> binary;
};
/// Throws Error{file} for what is neither a text that starts with '{' nor a sound GLB of version 2.
GltfContainer split_gltf(const Input& input);

/// A GLB with both chunks, filled up to multiples of 4. Throws Error{file, "E_FILE_TOO_LARGE"} past 4 GiB.
std::string pack_glb(std::string json, std::string_view binary, const Input& input);

/// What stands before the binary chunk of a GLB: its header, the JSON chunk, the header of the binary chunk. The lengths of both
/// are multiples of 4.
std::string glb_head(std::string_view json, std::size_t binary_size);

/// The bytes in base64.
void write_base64(Writer& out, std::string_view bytes);

}  // namespace udcp
