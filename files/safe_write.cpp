// Files in and out: whole files are read at once; what is written appears complete or not at all.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "files/file_io.h"
#include "files/geometry_file.h"
#include "operators/error.h"

namespace udcp {
namespace {

namespace fs = std::filesystem;

// The disk starts on a large file while the rest of it is still being made; then the flush at the end has little left to do.
constexpr std::size_t writeback_piece = std::size_t{8} << 20;

[[noreturn]] void fail_write(const fs::path& file, const std::string& reason, const std::string& help = {}) {
  throw Error(ErrorKind::file, "E_FILE_WRITE", "cannot write " + file.string() + ": " + reason, help);
}

std::string reason_of(int error) { return std::generic_category().message(error); }

/// Where a chain of symbolic links ends; the end need not exist.
fs::path follow_links(const fs::path& file) {
  fs::path target = file;
  std::error_code ignored;
  for (int links = 0; fs::is_symlink(fs::symlink_status(target, ignored)); ++links) {
    if (links == 40) fail_write(file, "too many levels of symbolic links");
    const fs::path next = fs::read_symlink(target, ignored);
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target;
}

/// A new empty file next to `target`, of a name that was not there; its mode follows the umask.
std::pair<int, fs::path> create_beside(const fs::path& target) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const std::string name = ".udcp-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp";
    const fs::path path = target.parent_path() / name;
    const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0 || errno != EEXIST) return {fd, path};
  }
  return {-1, {}};
}

/// The temporary of a file whose folder must exist.
std::pair<int, fs::path> open_temporary(const fs::path& file, const fs::path& target) {
  auto made = create_beside(target);
  if (made.first >= 0) return made;
  const int error = errno;
  fail_write(file, error == ENOENT ? "the folder does not exist" : "no file can be made in its folder: " + reason_of(error),
             error == ENOENT ? "make the folder first" : "");
}

[[noreturn]] void fail_on_disk(const fs::path& file, int error) {
  fail_write(file, reason_of(error),
             error == ENOSPC || error == EDQUOT ? "the disk is full; the old file, if any, is untouched" : "");
}

}  // namespace

Descriptor::~Descriptor() {
  if (fd_ >= 0) ::close(fd_);
}

bool Descriptor::close() { return ::close(std::exchange(fd_, -1)) == 0; }

FileSink::FileSink(const fs::path& file) : file_(file) {
  if (file.empty()) throw Error(ErrorKind::file, "E_FILE_WRITE", "cannot write: the file name is empty");
  struct stat status {};
  const bool exists = ::stat(file.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) fail_write(file, reason_of(errno));
  if (!exists && !file.has_filename()) fail_write(file, "the folder does not exist", "make the folder first");
  if (exists && S_ISDIR(status.st_mode)) fail_write(file, "it is a folder", "give a file name");
  if (exists && !S_ISREG(status.st_mode)) {
    out_ = Descriptor(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
    if (out_.get() < 0) fail_write(file, reason_of(errno));
    return;
  }
  if (exists && ::access(file.c_str(), W_OK) != 0) fail_write(file, reason_of(errno), "the file is write-protected");
  target_ = follow_links(file);
  auto [fd, temporary] = open_temporary(file, target_);
  out_ = Descriptor(fd);
  if (exists && ::fchmod(fd, status.st_mode & 07777) != 0) {
    const int error = errno;
    ::unlink(temporary.c_str());
    fail_on_disk(file, error);
  }
  temporary_ = std::move(temporary);
}

FileSink::~FileSink() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void FileSink::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(out_.get(), bytes.data(), std::min(bytes.size(), writeback_piece));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_on_disk(file_, errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
    written_ += static_cast<std::size_t>(written);
    if (written_ - started_ >= writeback_piece) start_writeback();
  }
}

void FileSink::start_writeback() {
#ifdef SYNC_FILE_RANGE_WRITE
  if (!temporary_.empty()) {  // an error will come back from fsync
    static_cast<void>(::sync_file_range(out_.get(), static_cast<off_t>(started_), static_cast<off_t>(written_ - started_),
                                        SYNC_FILE_RANGE_WRITE));
  }
#endif
  started_ = written_;
}

void FileSink::commit() {
  const bool beside = !temporary_.empty();
  if (beside && ::fsync(out_.get()) != 0) fail_on_disk(file_, errno);
  if (!out_.close()) fail_on_disk(file_, errno);
  if (!beside) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail_on_disk(file_, errno);
  temporary_.clear();
  // The name itself is only safe once the folder is on the disk; not every file system can do that.
  const Descriptor folder(
      ::open(target_.has_parent_path() ? target_.parent_path().c_str() : ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() >= 0) static_cast<void>(::fsync(folder.get()));
}

void write_file(const fs::path& file, const std::string& bytes) {
  FileSink out(file);
  out.write(bytes);
  out.commit();
}

FileBytes read_bytes(const fs::path& file, std::uintmax_t limit) {
  const auto fail = [&](const std::string& reason) {
    throw Error(ErrorKind::file, "E_FILE_OPEN", "cannot read " + file.string() + ": " + reason);
  };
  Descriptor in(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (in.get() < 0 || ::fstat(in.get(), &status) != 0) fail(reason_of(errno));
  if (S_ISDIR(status.st_mode)) fail("it is a folder");
  const auto too_large = [&] {
    throw Error(ErrorKind::file, "E_FILE_TOO_LARGE",
                file.string() + " is larger than the limit of " + std::to_string(limit) + " bytes");
  };
  const auto size = S_ISREG(status.st_mode) ? static_cast<std::uintmax_t>(status.st_size) : 0;
  if (size > limit) too_large();
  FileBytes bytes;
  for (std::size_t room = 0;;) {  // also for pipes and files that grow
    if (bytes.size == room) {
      room = room == 0 ? static_cast<std::size_t>(size) + 1 : room + room / 2 + 65536;
      auto larger = std::make_unique_for_overwrite<char[]>(room);
      std::copy_n(bytes.data.get(), bytes.size, larger.get());
      bytes.data = std::move(larger);
    }
    const ssize_t got = ::read(in.get(), bytes.data.get() + bytes.size, room - bytes.size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(reason_of(errno));
    if (got == 0) return bytes;
    bytes.size += static_cast<std::size_t>(got);
    if (bytes.size > limit) too_large();
  }
}

std::string read_file(const fs::path& file, std::uintmax_t limit) { return std::string(read_bytes(file, limit).view()); }

}  // namespace udcp
