// Where writers put their bytes: into memory, or through a small buffer into a file. Numbers become the shortest decimals that
// read back to the same value, without streams or locale. Knows no format.
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "files/file_io.h"

namespace udcp {

// Binary formats are little endian, and arrays are written as they lie in memory.
static_assert(std::endian::native == std::endian::little);

class Writer {
 public:
  /// Into memory; take() hands it out. Both: writing throws E_INTERRUPTED soon after `stop` is set.
  explicit Writer(std::size_t expected_size, const std::atomic<bool>* stop = nullptr);
  /// Into a file, which is opened when the first bytes go there and appears with commit(); errors of write_file.
  explicit Writer(std::filesystem::path file, const std::atomic<bool>* stop = nullptr);

  /// A place for at least so many bytes; `filled` says where those that were written there end.
  char* room(std::size_t bytes) {
    if (bytes > static_cast<std::size_t>(end_ - at_)) make_room(bytes);
    return at_;
  }
  void filled(char* end) { at_ = end; }

  Writer& operator<<(std::string_view part) {
    if (part.size() >= large_piece) {
      write_large(part);
    } else {
      char* to = room(part.size());
      at_ = std::copy(part.begin(), part.end(), to);
    }
    return *this;
  }
  Writer& operator<<(char c) {
    *room(1) = c;
    ++at_;
    return *this;
  }
  template <class Number>
  requires std::is_arithmetic_v<Number> Writer& operator<<(Number value) {
    char* to = room(longest_number);
    at_ = std::to_chars(to, to + longest_number, value).ptr;
    return *this;
  }
  /// The values as they lie in memory; many of them are not copied on their way to a file.
  template <class T>
  void write(std::span<const T> values) {
    static_assert(std::is_arithmetic_v<T>);
    *this << std::string_view(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  }

  /// Everything so far; only in memory.
  std::string take();
  /// Makes the file appear; only for files.
  void commit();

  static constexpr std::size_t longest_number = 40;

 private:
  static constexpr std::size_t large_piece = std::size_t{1} << 16;
  void make_room(std::size_t bytes);
  void write_large(std::string_view bytes);
  void flush();
  void pass_on(std::string_view bytes);

  std::unique_ptr<char[]> buffer_;
  char* at_ = nullptr;
  char* end_ = nullptr;
  std::string text_;  // in memory: what has left the buffer
  const std::atomic<bool>* stop_;
  bool to_file_ = false;
  std::filesystem::path file_;
  std::optional<FileSink> sink_;
};

/// One number in a place of at least Writer::longest_number bytes; returns its end.
template <class Number>
char* put_number(char* to, Number value) {
  return std::to_chars(to, to + Writer::longest_number, value).ptr;
}
/// The bytes of a number, least significant first; returns their end.
template <class Number>
char* put_bytes(char* to, Number value) {
  std::memcpy(to, &value, sizeof value);
  return to + sizeof value;
}

/// "Made by udcp" and the word, in one line.
std::string comment_line(const std::string& word);

}  // namespace udcp
