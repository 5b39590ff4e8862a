// Headers, chunks and padding of GLB files.
#include "files/gltf_container.h"

#include <algorithm>
#include <limits>

namespace udcp {
namespace {

constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k) value |= std::uint32_t{static_cast<unsigned char>(bytes[at + k])} << (8 * k);
  return value;
}

void put_word(std::string& bytes, std::size_t value) {
  for (std::size_t k = 0; k < 4; ++k) bytes.push_back(static_cast<char>(value >> (8 * k) & 0xff));
}

/// Bytes after the header of the GLB, up to the length that it promises.
std::string_view chunks_of(const Input& input) {
  const std::string_view bytes = input.bytes;
  if (bytes.size() < 20) input.fail(0, "E_FILE_FORMAT", "the file ends inside the header of the GLB");
  if (word_at(bytes, 4) != 2)
    input.fail(0, "E_FILE_FORMAT", "version " + std::to_string(word_at(bytes, 4)) + " of GLB is not supported; 2 is");
  const std::size_t length = word_at(bytes, 8);
  if (length > bytes.size()) {
    input.fail(0, "E_FILE_COUNT",
               "the header promises " + std::to_string(length) + " bytes, but the file has " + std::to_string(bytes.size()),
               "the file is cut off or damaged");
  }
  return length < 12 ? std::string_view() : bytes.substr(12, length - 12);
}

}  // namespace

GltfContainer split_gltf(const Input& input) {
  const std::string_view bytes = input.bytes;
  if (bytes.empty()) input.fail(0, "E_FILE_EMPTY", "the file is empty");
  if (!bytes.starts_with("glTF")) {
    if (const auto first = bytes.find_first_not_of(" \t\r\n"); first != std::string_view::npos && bytes[first] == '{')
      return {bytes, {}};
    input.fail(0, "E_FILE_FORMAT",
               "the file starts with " + in_quotes(bytes.substr(0, 4)) + "; a GLB starts with 'glTF', a glTF with '{'");
  }
  GltfContainer result;
  std::string_view rest = chunks_of(input);
  for (std::size_t chunk = 0; !rest.empty(); ++chunk) {
    if (rest.size() < 8) input.fail(0, "E_FILE_FORMAT", "the file ends inside the header of chunk " + std::to_string(chunk));
    const std::size_t size = word_at(rest, 0);
    const std::uint32_t type = word_at(rest, 4);
    rest.remove_prefix(8);
    if (size > rest.size())
      input.fail(0, "E_FILE_COUNT",
                 "chunk " + std::to_string(chunk) + " promises " + std::to_string(size) + " bytes, but only " +
                     std::to_string(rest.size()) + " follow");
    if (chunk == 0 && type != json_chunk) input.fail(0, "E_FILE_FORMAT", "the first chunk of the GLB is not JSON");
    if (chunk == 0) result.json = rest.substr(0, size);
    if (chunk == 1 && type == binary_chunk) result.binary = rest.substr(0, size);
    rest.remove_prefix(size);
  }
  return result;
}

std::string glb_head(std::string_view json, std::size_t binary_size) {
  std::string glb = "glTF";
  put_word(glb, 2);
  put_word(glb, 12 + 8 + json.size() + 8 + binary_size);
  put_word(glb, json.size());
  put_word(glb, json_chunk);
  glb += json;
  put_word(glb, binary_size);
  put_word(glb, binary_chunk);
  return glb;
}

std::string pack_glb(std::string json, std::string_view binary, const Input& input) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::size_t filled = (binary.size() + 3) / 4 * 4, total = 12 + 8 + json.size() + 8 + filled;
  if (total > std::numeric_limits<std::uint32_t>::max()) input.fail(0, "E_FILE_TOO_LARGE", "the file has more than 4 GiB");
  std::string glb = glb_head(json, filled);
  glb.reserve(total);
  glb += binary;
  glb.resize(total, '\0');
  return glb;
}

void write_base64(Writer& out, std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (; !bytes.empty(); bytes.remove_prefix(std::min<std::size_t>(3, bytes.size()))) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U);
    char* to = out.room(4);
    for (std::size_t k = 0; k < 4; ++k) to[k] = k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
    out.filled(to + 4);
  }
}

}  // namespace udcp
