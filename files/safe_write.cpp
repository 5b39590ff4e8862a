// Files in and out: whole files are read at once; what is written appears complete or not at all.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "files/geometry_file.h"
#include "operators/error.h"

namespace udcp {
namespace {

namespace fs = std::filesystem;

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_;
};

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

bool write_all(int fd, const std::string& bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t written = ::write(fd, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    done += static_cast<std::size_t>(written);
  }
  return true;
}

void write_directly(const fs::path& file, const std::string& bytes) {
  Descriptor out(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  if (out.get() < 0 || !write_all(out.get(), bytes) || !out.close()) fail_write(file, reason_of(errno));
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

void write_beside(const fs::path& file, const fs::path& target, const std::string& bytes, const struct stat* existing) {
  const auto [fd, temporary] = create_beside(target);
  if (fd < 0) {
    const int error = errno;
    fail_write(file, error == ENOENT ? "the folder does not exist" : "no file can be made in its folder: " + reason_of(error),
               error == ENOENT ? "make the folder first" : "");
  }
  Descriptor out(fd);
  const bool moded = existing == nullptr || ::fchmod(out.get(), existing->st_mode & 07777) == 0;
  const bool done = moded && write_all(out.get(), bytes) && ::fsync(out.get()) == 0 && out.close() &&
                    ::rename(temporary.c_str(), target.c_str()) == 0;
  if (done) {  // the name itself is only safe once the folder is on the disk; not every file system can do that
    const Descriptor folder(
        ::open(target.has_parent_path() ? target.parent_path().c_str() : ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder.get() >= 0) static_cast<void>(::fsync(folder.get()));
    return;
  }
  const int error = errno;
  ::unlink(temporary.c_str());
  fail_write(file, reason_of(error),
             error == ENOSPC || error == EDQUOT ? "the disk is full; the old file, if any, is untouched" : "");
}

}  // namespace

void write_file(const fs::path& file, const std::string& bytes) {
  if (file.empty()) throw Error(ErrorKind::file, "E_FILE_WRITE", "cannot write: the file name is empty");
  struct stat status {};
  const bool exists = ::stat(file.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) fail_write(file, reason_of(errno));
  if (!exists && !file.has_filename()) fail_write(file, "the folder does not exist", "make the folder first");
  if (exists && S_ISDIR(status.st_mode)) fail_write(file, "it is a folder", "give a file name");
  if (exists && !S_ISREG(status.st_mode)) return write_directly(file, bytes);
  if (exists && ::access(file.c_str(), W_OK) != 0) fail_write(file, reason_of(errno), "the file is write-protected");
  write_beside(file, follow_links(file), bytes, exists ? &status : nullptr);
}

std::string read_file(const fs::path& file, std::uintmax_t limit) {
  const auto fail = [&](const std::string& reason) {
    throw Error(ErrorKind::file, "E_FILE_OPEN", "cannot read " + file.string() + ": " + reason);
  };
  Descriptor in(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (in.get() < 0 || ::fstat(in.get(), &status) != 0) fail(reason_of(errno));
  if (S_ISDIR(status.st_mode)) fail("it is a folder");
  std::string bytes;
  const auto too_large = [&] {
    throw Error(ErrorKind::file, "E_FILE_TOO_LARGE",
                file.string() + " is larger than the limit of " + std::to_string(limit) + " bytes");
  };
  const auto size = S_ISREG(status.st_mode) ? static_cast<std::uintmax_t>(status.st_size) : 0;
  if (size > limit) too_large();
  std::size_t filled = 0;
  for (;;) {  // also for pipes and files that grow
    if (filled == bytes.size()) bytes.resize(filled == 0 ? static_cast<std::size_t>(size) + 1 : filled + filled / 2 + 65536);
    const ssize_t got = ::read(in.get(), bytes.data() + filled, bytes.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(reason_of(errno));
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
    if (filled > limit) too_large();
  }
  bytes.resize(filled);
  return bytes;
}

}  // namespace udcp
