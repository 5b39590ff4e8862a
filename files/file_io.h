// Large files out and in without copies: one that is written in pieces and appears complete or not at all, and one that is read
// whole. Knows no format; write_file and read_file are the same for strings.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>

namespace udcp {

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~Descriptor();
  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] bool close();

 private:
  int fd_;
};

/// Writes to a temporary file in the same folder; commit() flushes it to the disk and renames it over `file`. Without commit, and
/// after any error, `file` is as it was and no temporary is left. Links, modes, devices and errors as for write_file.
class FileSink {
 public:
  explicit FileSink(const std::filesystem::path& file);
  FileSink(const FileSink&) = delete;
  FileSink& operator=(const FileSink&) = delete;
  ~FileSink();
  /// The bytes go to the system as they are, without a copy here: pieces should be large.
  void write(std::string_view bytes);
  void commit();

 private:
  void start_writeback();

  std::filesystem::path file_, target_, temporary_;  // no temporary: written directly, or done
  Descriptor out_;
  std::size_t written_ = 0, started_ = 0;  // bytes given to the system, and those it was told to bring to the disk
};

/// The bytes of a whole file.
struct FileBytes {
  std::unique_ptr<char[]> data;
  std::size_t size = 0;
  [[nodiscard]] std::string_view view() const { return {data.get(), size}; }
};
/// Errors as for read_file.
FileBytes read_bytes(const std::filesystem::path& file, std::uintmax_t limit = std::uintmax_t{1} << 32);

}  // namespace udcp
