// The JSON and the URIs of a glTF file, member by member; what is not copied here never reaches tinygltf. In
// particular not what tinygltf 2.7 cannot bear: deep nesting in extras, images outside their buffer, paths, integers beyond int.
#include "files/gltf_filter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "files/gltf_container.h"

namespace udcp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t most_json = std::size_t{256} << 20;
constexpr std::size_t most_entries = 1'000'000;  // an entry of three bytes takes half a kilobyte in tinygltf
constexpr std::size_t most_bytes = std::size_t{1} << 32;
constexpr std::uint64_t most_index = std::numeric_limits<int>::max(), most_offset = std::uint64_t{1} << 40;
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

class GltfFilter {
 public:
  explicit GltfFilter(const Input& input) : input_(input), container_(split_gltf(input)) {}
  FilteredGltf run();

 private:
  using Keep = Json (GltfFilter::*)(const Json& entry, const std::string& name);
  using Used = std::vector<char>;

  void parse(std::string_view text);
  void check_asset() const;

  Json keep_scene(const Json& scene, const std::string& name);
  Json keep_node(const Json& node, const std::string& name);
  Json keep_mesh(const Json& mesh, const std::string& name);
  Json keep_primitive(const Json& primitive, const std::string& name);
  Json keep_accessor(const Json& accessor, const std::string& name);
  Json keep_view(const Json& view, const std::string& name);
  Json keep_buffer(const Json& buffer, const std::string& name);
  [[nodiscard]] std::string data_uri(const std::string& uri, std::size_t length, const std::string& name) const;
  std::string load_file(const std::string& uri, const std::string& name);

  Json keep_all(const char* list, Keep keep);
  Json keep_used(const char* list, Keep keep, const Used& used, const Json& empty);
  void count_entry();
  void copy_integer(const Json& from, const char* key, const std::string& name, Json& to, std::uint64_t most = most_index) const;
  void copy_integers(const Json& from, const char* key, const std::string& name, Json& to) const;
  void copy_numbers(const Json& from, const char* key, std::size_t count, const std::string& name, Json& to) const;
  void copy_index(const Json& from, const char* key, const std::string& name, Json& to, const char* list, Used& used) const;
  [[nodiscard]] const Json& member(const Json& object, const char* key, const std::string& name) const;
  [[nodiscard]] std::size_t integer(const Json& value, const std::string& name, std::uint64_t most = most_index) const;
  [[nodiscard]] std::size_t size(const char* list) const;
  void expect_bytes(const std::string& name, std::size_t promised, std::size_t present) const;
  [[noreturn]] void fail(const char* code, const std::string& message, const std::string& help = {}) const {
    input_.fail(0, code, message, help);
  }

  const Input& input_;
  const GltfContainer container_;
  Json root_;
  bool uses_binary_ = false;
  Used used_accessors_, used_views_, used_buffers_;
  std::size_t entries_ = 0, loaded_ = 0;
  std::map<std::string, std::string> files_;
};

FilteredGltf GltfFilter::run() {
  parse(container_.json);
  check_asset();
  used_accessors_.resize(size("accessors"));
  used_views_.resize(size("bufferViews"));
  used_buffers_.resize(size("buffers"));
  Json kept = Json::object();
  kept["asset"]["version"] = "2.0";
  copy_integer(root_, "scene", "the file", kept);
  kept["scenes"] = keep_all("scenes", &GltfFilter::keep_scene);
  kept["nodes"] = keep_all("nodes", &GltfFilter::keep_node);
  kept["meshes"] = keep_all("meshes", &GltfFilter::keep_mesh);
  kept["accessors"] = keep_used("accessors", &GltfFilter::keep_accessor, used_accessors_,
                                {{"componentType", 5126}, {"count", 0}, {"type", "SCALAR"}});
  kept["bufferViews"] = keep_used("bufferViews", &GltfFilter::keep_view, used_views_, {{"buffer", 0}, {"byteLength", 0}});
  kept["buffers"] = keep_used("buffers", &GltfFilter::keep_buffer, used_buffers_,
                              {{"byteLength", 1}, {"uri", "data:application/octet-stream;base64,AA"}});
  root_ = nullptr;
  std::string text = kept.dump();
  if (uses_binary_) text = pack_glb(std::move(text), *container_.binary, input_);
  return {std::move(text), uses_binary_, std::move(files_)};
}

void GltfFilter::parse(std::string_view text) {
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

void GltfFilter::check_asset() const {
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

Json GltfFilter::keep_scene(const Json& scene, const std::string& name) {
  Json kept = Json::object();
  copy_integers(scene, "nodes", name, kept);
  return kept;
}

Json GltfFilter::keep_node(const Json& node, const std::string& name) {
  Json kept = Json::object();
  copy_integer(node, "mesh", name, kept);
  copy_integers(node, "children", name, kept);
  copy_numbers(node, "matrix", 16, name, kept);
  copy_numbers(node, "rotation", 4, name, kept);
  copy_numbers(node, "scale", 3, name, kept);
  copy_numbers(node, "translation", 3, name, kept);
  return kept;
}

Json GltfFilter::keep_mesh(const Json& mesh, const std::string& name) {
  const auto primitives = mesh.find("primitives");
  if (primitives == mesh.end() || !primitives->is_array()) fail("E_FILE_SYNTAX", name + " has no list of primitives");
  Json kept = Json::object();
  Json& list = kept["primitives"] = Json::array();
  for (std::size_t k = 0; k < primitives->size(); ++k) {
    const Json& primitive = (*primitives)[k];
    const std::string place = name + ".primitives[" + std::to_string(k) + "]";
    count_entry();
    if (!primitive.is_object()) fail("E_FILE_SYNTAX", place + " is not an object");
    list.push_back(keep_primitive(primitive, place));
  }
  return kept;
}

Json GltfFilter::keep_primitive(const Json& primitive, const std::string& name) {
  const auto attributes = primitive.find("attributes");
  if (attributes == primitive.end() || !attributes->is_object()) fail("E_FILE_SYNTAX", name + " has no attributes");
  Json kept = Json::object();
  copy_integer(primitive, "mode", name, kept);
  Json& list = kept["attributes"] = Json::object();
  for (const char* key : {"POSITION", "NORMAL"}) {
    if (attributes->contains(key)) copy_index(*attributes, key, name, list, "accessors", used_accessors_);
  }
  if (primitive.contains("indices")) copy_index(primitive, "indices", name, kept, "accessors", used_accessors_);
  return kept;
}

Json GltfFilter::keep_accessor(const Json& accessor, const std::string& name) {
  if (accessor.contains("sparse"))
    fail("E_FILE_FORMAT", name + " is sparse, which is not supported", "export without sparse accessors");
  const auto type = accessor.find("type");
  const bool known = type != accessor.end() && std::ranges::any_of(std::array{"SCALAR", "VEC2", "VEC3", "VEC4"},
                                                                   [&](const char* kind) { return *type == kind; });
  if (!known) fail("E_FILE_FORMAT", name + " has no type that is understood here");
  const std::size_t component = integer(member(accessor, "componentType", name), name + ".componentType");
  if (component < 5120 || component > 5126 || component == 5124)
    fail("E_FILE_FORMAT", name + " has an unknown componentType " + std::to_string(component));
  Json kept = {{"type", *type}, {"componentType", component}};
  kept["count"] = integer(member(accessor, "count", name), name + ".count", most_offset);
  copy_integer(accessor, "byteOffset", name, kept, most_offset);
  copy_index(accessor, "bufferView", name, kept, "bufferViews", used_views_);
  return kept;
}

Json GltfFilter::keep_view(const Json& view, const std::string& name) {
  Json kept = Json::object();
  copy_index(view, "buffer", name, kept, "buffers", used_buffers_);
  copy_integer(view, "byteOffset", name, kept, most_offset);
  kept["byteLength"] = integer(member(view, "byteLength", name), name + ".byteLength", most_offset);
  copy_integer(view, "byteStride", name, kept);
  if (const auto stride = kept.find("byteStride"); stride != kept.end()) {
    const auto value = stride->get<std::size_t>();
    if (value < 4 || value > 252 || value % 4 != 0)
      fail("E_FILE_FORMAT", name + " has a byteStride of " + std::to_string(value) + "; only 4, 8, ..., 252 are legal");
  }
  return kept;
}

/// tinygltf takes no empty buffers, and none that are longer than they promise.
Json GltfFilter::keep_buffer(const Json& buffer, const std::string& name) {
  const std::size_t length = integer(member(buffer, "byteLength", name), name + ".byteLength", most_offset);
  if (length == 0) fail("E_FILE_COUNT", name + " has no bytes");
  Json kept = {{"byteLength", length}};
  const auto found = buffer.find("uri");
  if (found == buffer.end()) {
    if (name != "buffers[0]" || !container_.binary)
      fail("E_FILE_FORMAT", name + " has no uri, and the file has no binary chunk for it");
    expect_bytes(name, length, container_.binary->size());
    uses_binary_ = true;
    return kept;
  }
  if (!found->is_string()) fail("E_FILE_SYNTAX", name + ".uri is not a text");
  const auto& uri = found->get_ref<const std::string&>();
  if (uri.starts_with("data:")) {
    kept["uri"] = data_uri(uri, length, name);
    return kept;
  }
  std::string bytes = load_file(uri, name);
  expect_bytes(name, length, bytes.size());
  bytes.resize(length);
  files_.emplace(name, std::move(bytes));
  kept["uri"] = name;  // instead of a path: unique, and without an escape
  return kept;
}

/// The data with the one media type that every reader knows, cut to the bytes that count.
std::string GltfFilter::data_uri(const std::string& uri, std::size_t length, const std::string& name) const {
  const auto comma = uri.find(";base64,");
  std::string_view digits = comma == std::string::npos ? std::string_view() : std::string_view(uri).substr(comma + 8);
  while (digits.ends_with('=')) digits.remove_suffix(1);
  constexpr auto all_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  if (comma == std::string::npos || digits.find_first_not_of(all_digits) != std::string_view::npos)
    fail("E_FILE_SYNTAX", name + ".uri is no base64 data");
  expect_bytes(name, length, digits.size() * 3 / 4);
  return "data:application/octet-stream;base64," + std::string(digits.substr(0, (4 * length + 2) / 3));
}

std::string GltfFilter::load_file(const std::string& uri, const std::string& name) {
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
  std::string bytes = read_file(file);
  loaded_ += bytes.size();  // many buffers may name one large file
  if (loaded_ > most_bytes) fail("E_FILE_TOO_LARGE", "the buffers in other files have more than 4 GiB");
  return bytes;
}

Json GltfFilter::keep_all(const char* list, Keep keep) { return keep_used(list, keep, Used(size(list), 1), nullptr); }

Json GltfFilter::keep_used(const char* list, Keep keep, const Used& used, const Json& empty) {
  Json kept = Json::array();
  for (std::size_t k = 0; k < used.size(); ++k) {
    count_entry();
    if (used[k] == 0) {
      kept.push_back(empty);
      continue;
    }
    const Json& entry = root_[list][k];
    const std::string name = std::string(list) + "[" + std::to_string(k) + "]";
    if (!entry.is_object()) fail("E_FILE_SYNTAX", name + " is not an object");
    kept.push_back((this->*keep)(entry, name));
  }
  return kept;
}

void GltfFilter::count_entry() {
  if (++entries_ > most_entries)
    fail("E_FILE_TOO_LARGE", "the lists of the file have more than " + std::to_string(most_entries) + " entries");
}

void GltfFilter::copy_integer(const Json& from, const char* key, const std::string& name, Json& to, std::uint64_t most) const {
  if (const auto found = from.find(key); found != from.end()) to[key] = integer(*found, name + "." + key, most);
}

void GltfFilter::copy_integers(const Json& from, const char* key, const std::string& name, Json& to) const {
  const auto found = from.find(key);
  if (found == from.end()) return;
  const std::string place = name + "." + key;
  if (!found->is_array()) fail("E_FILE_SYNTAX", place + " is not a list");
  Json& list = to[key] = Json::array();
  for (const Json& value : *found) list.push_back(integer(value, place));
}

/// A list of `count` finite numbers.
void GltfFilter::copy_numbers(const Json& from, const char* key, std::size_t count, const std::string& name, Json& to) const {
  const auto found = from.find(key);
  if (found == from.end()) return;
  if (!found->is_array() || found->size() != count)
    fail("E_FILE_SYNTAX", name + "." + key + " needs " + std::to_string(count) + " numbers");
  Json& list = to[key] = Json::array();
  for (const Json& value : *found) {
    if (!value.is_number() || !std::isfinite(value.get<double>()))
      fail("E_FILE_NUMBER", name + "." + key + " holds something that is not a finite number");
    list.push_back(value.get<double>());
  }
}

/// An index into a list of the file, whose entry it marks as used.
void GltfFilter::copy_index(const Json& from, const char* key, const std::string& name, Json& to, const char* list,
                            Used& used) const {
  const std::string place = name + "." + key;
  const std::size_t index = integer(member(from, key, name), place);
  if (index >= used.size()) {
    fail("E_FILE_INDEX",
         place + " names entry " + std::to_string(index) + " of " + list + ", but there are " + std::to_string(used.size()));
  }
  used[index] = 1;
  to[key] = index;
}

const Json& GltfFilter::member(const Json& object, const char* key, const std::string& name) const {
  const auto found = object.find(key);
  if (found == object.end()) fail("E_FILE_SYNTAX", name + " has no " + key);
  return *found;
}

std::size_t GltfFilter::integer(const Json& value, const std::string& name, std::uint64_t most) const {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > most)
    fail("E_FILE_NUMBER", name + " is not a non-negative integer of reasonable size");
  return value.get<std::size_t>();
}

/// Entries of a top-level list; 0 if there is none.
std::size_t GltfFilter::size(const char* list) const {
  const auto found = root_.find(list);
  return found == root_.end() ? 0 : found->size();
}

void GltfFilter::expect_bytes(const std::string& name, std::size_t promised, std::size_t present) const {
  if (promised > present) {
    fail("E_FILE_COUNT", name + " promises " + std::to_string(promised) + " bytes, but there are " + std::to_string(present));
  }
}

}  // namespace

FilteredGltf filter_gltf(const Input& input) { return GltfFilter(input).run(); }

}  // namespace udcp
