// The container, the JSON and the buffers of a glTF file, with all checks.
#include "files/gltf_document.h"

#include <algorithm>
#include <cmath>

namespace udcp {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_json = std::size_t{256} << 20;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k) value |= std::uint32_t{static_cast<unsigned char>(bytes[at + k])} << (8 * k);
  return value;
}

std::size_t component_size(int type) {
  switch (type) {
    case 5120:
    case 5121:
      return 1;
    case 5122:
    case 5123:
      return 2;
    default:
      return 4;
  }
}

/// Bytes of a base64 text; false if it is none.
bool decode_base64(std::string_view text, std::string& bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  while (text.ends_with('=')) text.remove_suffix(1);
  std::uint32_t bits = 0;
  int filled = 0;
  bytes.reserve(text.size() / 4 * 3 + 3);
  for (const char c : text) {
    const auto value = digits.find(c);
    if (value == std::string_view::npos) return false;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    filled += 6;
    if (filled < 8) continue;
    filled -= 8;
    bytes.push_back(static_cast<char>(bits >> filled & 0xff));
  }
  return true;
}

/// "my%20file.bin" to "my file.bin".
std::string decode_percent(const std::string& uri) {
  std::string result;
  for (std::size_t k = 0; k < uri.size(); ++k) {
    unsigned value = 0;
    const bool escape = uri[k] == '%' && k + 2 < uri.size() &&
                        std::from_chars(uri.data() + k + 1, uri.data() + k + 3, value, 16).ptr == uri.data() + k + 3;
    result += escape ? static_cast<char>(value) : uri[k];
    if (escape) k += 2;
  }
  return result;
}

}  // namespace

GltfDocument::GltfDocument(const Input& input) : input_(input) {
  parse(split_container());
  check_asset();
}

std::size_t GltfDocument::size(const char* list) const {
  const auto found = root_.find(list);
  return found == root_.end() ? 0 : found->size();
}

const GltfDocument::Json& GltfDocument::element(const char* list, std::size_t index, const std::string& where) const {
  if (index >= size(list)) {
    fail("E_FILE_INDEX",
         where + " names entry " + std::to_string(index) + " of " + list + ", but there are " + std::to_string(size(list)));
  }
  const Json& found = root_[list][index];
  if (!found.is_object()) fail("E_FILE_SYNTAX", std::string(list) + "[" + std::to_string(index) + "] is not an object");
  return found;
}

std::size_t GltfDocument::integer(const Json& object, const char* key, const std::string& where, std::int64_t missing) const {
  const auto found = object.find(key);
  if (found != object.end()) return integer(*found, where + "." + key);
  if (missing < 0) fail("E_FILE_SYNTAX", where + " has no " + key);
  return static_cast<std::size_t>(missing);
}

std::size_t GltfDocument::integer(const Json& value, const std::string& where) const {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > (std::uint64_t{1} << 40)) {
    fail("E_FILE_NUMBER", where + " is not a non-negative integer of reasonable size");
  }
  return value.get<std::size_t>();
}

std::vector<double> GltfDocument::numbers(const Json& object, const char* key, std::size_t count,
                                          const std::string& where) const {
  const Json& list = object[key];
  if (!list.is_array() || list.size() != count)
    fail("E_FILE_SYNTAX", where + "." + key + " needs " + std::to_string(count) + " numbers");
  std::vector<double> result;
  for (const Json& value : list) {
    if (!value.is_number() || !std::isfinite(value.get<double>()))
      fail("E_FILE_NUMBER", where + "." + key + " holds something that is not a finite number");
    result.push_back(value.get<double>());
  }
  return result;
}

/// The JSON text; remembers the binary chunk of a GLB.
std::string_view GltfDocument::split_container() {
  const std::string_view bytes = input_.bytes;
  if (bytes.empty()) fail("E_FILE_EMPTY", "the file is empty");
  if (!bytes.starts_with("glTF")) {
    if (const auto first = bytes.find_first_not_of(" \t\r\n"); first != std::string_view::npos && bytes[first] == '{')
      return bytes;
    fail("E_FILE_FORMAT",
         "the file starts with " + in_quotes(bytes.substr(0, 4)) + "; a GLB starts with 'glTF', a glTF with '{'");
  }
  if (bytes.size() < 20) fail("E_FILE_FORMAT", "the file ends inside the header of the GLB");
  if (word_at(bytes, 4) != 2)
    fail("E_FILE_FORMAT", "version " + std::to_string(word_at(bytes, 4)) + " of GLB is not supported; 2 is");
  const std::size_t length = word_at(bytes, 8);
  if (length > bytes.size()) {
    fail("E_FILE_COUNT",
         "the header promises " + std::to_string(length) + " bytes, but the file has " + std::to_string(bytes.size()),
         "the file is cut off or damaged");
  }
  std::string_view text;
  for (std::size_t at = 12, chunk = 0; at < length; ++chunk) {
    if (length - at < 8) fail("E_FILE_FORMAT", "the file ends inside the header of chunk " + std::to_string(chunk));
    const std::size_t size = word_at(bytes, at);
    const std::uint32_t type = word_at(bytes, at + 4);
    at += 8;
    if (size > length - at)
      fail("E_FILE_COUNT", "chunk " + std::to_string(chunk) + " promises " + std::to_string(size) + " bytes, but only " +
                               std::to_string(length - at) + " follow");
    if (chunk == 0 && type != 0x4E4F534A) fail("E_FILE_FORMAT", "the first chunk of the GLB is not JSON");
    if (chunk == 0) text = bytes.substr(at, size);
    if (chunk == 1 && type == 0x004E4942) {
      binary_ = bytes.substr(at, size);
      has_binary_ = true;
    }
    at += size;
  }
  return text;
}

void GltfDocument::parse(std::string_view text) {
  if (text.size() > most_json) fail("E_FILE_TOO_LARGE", "the JSON part has more than 256 MiB");
  try {
    root_ = Json::parse(text);
  } catch (const Json::exception& error) {
    const std::string what = error.what();
    const auto from = what.find("] ");
    fail("E_FILE_SYNTAX", "the JSON is malformed: " + (from == std::string::npos ? what : what.substr(from + 2)));
  }
  if (!root_.is_object()) fail("E_FILE_SYNTAX", "the JSON is not an object");
  for (const char* list :
       {"scenes", "nodes", "meshes", "accessors", "bufferViews", "buffers", "animations", "skins", "extensionsRequired"}) {
    if (const auto found = root_.find(list); found != root_.end() && !found->is_array())
      fail("E_FILE_SYNTAX", std::string(list) + " is not a list");
  }
}

void GltfDocument::check_asset() const {
  const auto asset = root_.find("asset");
  const bool sound = asset != root_.end() && asset->is_object() && asset->contains("version") && (*asset)["version"].is_string();
  if (!sound) fail("E_FILE_SYNTAX", "asset.version is missing");
  const auto version = (*asset)["version"].get<std::string>();
  if (!version.starts_with("2.")) fail("E_FILE_FORMAT", "version " + in_quotes(version) + " of glTF is not supported; 2.0 is");
  if (size("extensionsRequired") > 0) {
    const Json& name = root_["extensionsRequired"][0];
    fail("E_FILE_FORMAT",
         "the file requires the extension " + in_quotes(name.is_string() ? name.get<std::string>() : "?") +
             ", which is not supported",
         "export without compression and extensions");
  }
  if (size("animations") > 0) input_.warn(0, "animations are not read");
  if (size("skins") > 0) input_.warn(0, "skins are not read; the mesh is taken in its rest position");
}

GltfView GltfDocument::view(std::size_t index, const std::string& what) {
  const Json& accessor = element("accessors", index, what);
  const std::string name = "accessors[" + std::to_string(index) + "]";
  if (accessor.contains("sparse"))
    fail("E_FILE_FORMAT", name + " is sparse, which is not supported", "export without sparse accessors");
  const std::map<std::string, int> kinds{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
  const auto type = accessor.find("type");
  const auto kind = type != accessor.end() && type->is_string() ? kinds.find(type->get<std::string>()) : kinds.end();
  if (kind == kinds.end()) fail("E_FILE_FORMAT", name + " has no type that is understood here");
  GltfView result;
  result.components = kind->second;
  const std::size_t component = integer(accessor, "componentType", name);
  if (component < 5120 || component > 5126 || component == 5124)
    fail("E_FILE_FORMAT", name + " has an unknown componentType " + std::to_string(component));
  result.component_type = static_cast<int>(component);
  result.count = integer(accessor, "count", name);
  const std::size_t offset = integer(accessor, "byteOffset", name, 0);
  const std::size_t view_index = integer(accessor, "bufferView", name);
  const Json& view = element("bufferViews", view_index, name);
  const std::string view_name = "bufferViews[" + std::to_string(view_index) + "]";
  const std::string_view bytes = buffer(integer(view, "buffer", view_name));
  const std::size_t start = integer(view, "byteOffset", view_name, 0), length = integer(view, "byteLength", view_name);
  if (start > bytes.size() || length > bytes.size() - start)
    fail("E_FILE_COUNT", view_name + " reaches past its buffer of " + std::to_string(bytes.size()) + " bytes");
  const std::size_t each = component_size(result.component_type) * static_cast<std::size_t>(result.components);
  result.stride = integer(view, "byteStride", view_name, static_cast<std::int64_t>(each));
  if (result.stride < each || result.stride > 252)
    fail("E_FILE_FORMAT",
         view_name + " has a byteStride of " + std::to_string(result.stride) + ", which does not fit its elements");
  const bool fits = result.count == 0 ||
                    (offset <= length && length - offset >= each && result.count - 1 <= (length - offset - each) / result.stride);
  if (!fits) {
    fail("E_FILE_COUNT", name + " promises " + std::to_string(result.count) + " elements of " + std::to_string(each) +
                             " bytes, but reaches past its view of " + std::to_string(length) + " bytes");
  }
  result.data = bytes.data() + start + std::min(offset, length);
  return result;
}

std::string_view GltfDocument::buffer(std::size_t index) {
  const Json& buffer = element("buffers", index, "a buffer view");
  const std::string name = "buffers[" + std::to_string(index) + "]";
  const std::size_t length = integer(buffer, "byteLength", name);
  std::string_view bytes;
  if (const auto uri = buffer.find("uri"); uri != buffer.end()) {
    if (!uri->is_string()) fail("E_FILE_SYNTAX", name + ".uri is not a text");
    auto known = loaded_.find(index);
    if (known == loaded_.end()) known = loaded_.emplace(index, load_uri(uri->get<std::string>(), name)).first;
    bytes = known->second;
  } else {
    if (index != 0 || !has_binary_) fail("E_FILE_FORMAT", name + " has no uri, and the file has no binary chunk for it");
    bytes = binary_;
  }
  if (length > bytes.size())
    fail("E_FILE_COUNT", name + " promises " + std::to_string(length) + " bytes, but there are " + std::to_string(bytes.size()));
  return bytes.substr(0, length);
}

std::string GltfDocument::load_uri(const std::string& uri, const std::string& name) const {
  if (uri.starts_with("data:")) {
    const auto comma = uri.find(";base64,");
    std::string bytes;
    if (comma == std::string::npos || !decode_base64(std::string_view(uri).substr(comma + 8), bytes))
      fail("E_FILE_SYNTAX", name + ".uri is no base64 data");
    return bytes;
  }
  if (input_.folder.empty())
    fail("E_FILE_OPEN", name + " lies in another file " + in_quotes(uri) + ", which cannot be read from here",
         "use a GLB, which holds everything");
  const fs::path path(decode_percent(uri));
  std::error_code error;
  const fs::path folder = fs::canonical(input_.folder, error), file = error ? fs::path() : fs::canonical(folder / path, error);
  if (error || path.is_absolute() || uri.find(':') != std::string::npos)
    fail("E_FILE_OPEN", name + " lies in " + in_quotes(uri) + ", which cannot be found beside the file");
  if (const fs::path inside = file.lexically_relative(folder); inside.empty() || *inside.begin() == "..") {
    fail("E_FILE_OPEN", name + " lies in " + in_quotes(uri) + ", outside the folder of the file; such paths are not followed");
  }
  return read_file(file);
}

}  // namespace udcp
