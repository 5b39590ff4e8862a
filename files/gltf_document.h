// A glTF or GLB file as checked data: the JSON library parses, and every index, offset and length is checked here before a byte
// is touched. Knows nothing of meshes.
#pragma once

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "files/scanner.h"

namespace udcp {

/// `count` elements of `components` numbers each, `stride` bytes apart, all inside the file.
struct GltfView {
  static constexpr int type_ubyte = 5121, type_ushort = 5123, type_uint = 5125, type_float = 5126;
  const char* data = nullptr;
  std::size_t count = 0, stride = 0;
  int component_type = 0, components = 0;

  [[nodiscard]] double real(std::size_t k, std::size_t c) const {
    float value = 0;
    std::memcpy(&value, data + k * stride + 4 * c, 4);
    return double{value};
  }
  [[nodiscard]] std::uint32_t index(std::size_t k) const {
    std::uint32_t value = 0;
    const std::size_t size = component_type == type_ubyte ? 1 : component_type == type_ushort ? 2 : 4;
    for (std::size_t b = 0; b < size; ++b) value |= std::uint32_t{static_cast<unsigned char>(data[k * stride + b])} << (8 * b);
    return value;
  }
};

class GltfDocument {
 public:
  using Json = nlohmann::json;

  /// Throws Error{file} for anything that is no glTF 2.0, and for required extensions.
  explicit GltfDocument(const Input& input);

  [[nodiscard]] const Json& root() const { return root_; }
  /// Entries of a top-level list; 0 if there is none.
  [[nodiscard]] std::size_t size(const char* list) const;
  /// Entry of a top-level list, an object; `where` names who asks for it.
  [[nodiscard]] const Json& element(const char* list, std::size_t index, const std::string& where) const;
  /// A non-negative integer: a member (`missing` if there is none), or a value.
  [[nodiscard]] std::size_t integer(const Json& object, const char* key, const std::string& where,
                                    std::int64_t missing = -1) const;
  [[nodiscard]] std::size_t integer(const Json& value, const std::string& where) const;
  /// A member that is a list of `count` finite numbers.
  [[nodiscard]] std::vector<double> numbers(const Json& object, const char* key, std::size_t count,
                                            const std::string& where) const;
  /// The elements of an accessor. The view lives as long as the document and its input.
  GltfView view(std::size_t accessor, const std::string& what);
  /// Bytes of the file, the measure of what a scene may expand to.
  [[nodiscard]] std::size_t bytes() const { return input_.bytes.size(); }
  [[noreturn]] void fail(const char* code, const std::string& message, const std::string& help = {}) const {
    input_.fail(0, code, message, help);
  }

 private:
  std::string_view split_container();
  void parse(std::string_view text);
  void check_asset() const;
  std::string_view buffer(std::size_t index);
  [[nodiscard]] std::string load_uri(const std::string& uri, const std::string& name) const;

  const Input& input_;
  Json root_;
  std::string_view binary_;
  bool has_binary_ = false;
  std::map<std::size_t, std::string> loaded_;  // buffers from URIs
};

}  // namespace udcp
