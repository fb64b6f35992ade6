// Whole files in and out. An output is written beside its path under a name of its own, then renamed.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <string>
#include <system_error>

#include "io/mesh.h"

namespace quoin::io {
namespace {

std::string reason(int code) { return std::generic_category().message(code); }

Error unreadable(const std::string& path, int code) {
  const bool missing = code == ENOENT || code == ENOTDIR;
  return Error{missing ? ErrorCode::missing_file : ErrorCode::unreadable, "cannot read the file: " + reason(code),
               path};
}

Error unwritable(const std::string& path, int code) {
  if (code == ECANCELED) return Error{ErrorCode::cancelled, "the writing was cancelled", path};
  return Error{ErrorCode::unwritable, "cannot write the file: " + reason(code), path};
}

/// A descriptor, closed at the end of its scope if it is owned.
class Descriptor {
 public:
  Descriptor(int number, bool owned) : number_(number), owned_(owned && number >= 0) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { (void)close(); }

  int number() const { return number_; }
  /// 0, or the error: a full disk may show only here.
  int close() {
    if (!owned_) return 0;
    owned_ = false;
    const int result = ::close(number_);
    return result == 0 || errno == EINTR ? 0 : errno;
  }

 private:
  int number_;
  bool owned_;
};

bool is_cancelled(const Cancel* cancel) { return cancel != nullptr && cancel->load(); }

/// A descriptor, or negative with errno.
int open_retrying(const char* path, int flags, const Cancel* cancel = nullptr) {
  for (;;) {
    const int number = ::open(path, flags | O_CLOEXEC, 0666);
    if (number >= 0 || errno != EINTR) return number;
    if (is_cancelled(cancel)) {
      errno = ECANCELED;
      return -1;
    }
  }
}

/// All bytes to the end of the file; the size is a hint. 0 or the error.
int read_all(int number, std::string& out) {
  constexpr std::size_t chunk = std::size_t{1} << 16;
  struct stat status;
  const bool regular = ::fstat(number, &status) == 0 && S_ISREG(status.st_mode);

  // One byte more than the size lets the last read see the end without growing.
  out.resize(regular ? static_cast<std::size_t>(status.st_size) + 1 : chunk);
  std::size_t size = 0;
  for (;;) {
    if (size == out.size()) out.resize(out.size() + std::max(chunk, out.size() / 2));
    const ssize_t got = ::read(number, out.data() + size, out.size() - size);
    if (got == 0) break;
    if (got > 0) size += static_cast<std::size_t>(got);
    if (got < 0 && errno != EINTR) return errno;
  }
  out.resize(size);
  return 0;
}

/// 0 or the error. The flag is asked before each piece, and when a signal interrupts one.
int write_all(int number, std::string_view bytes, const Cancel* cancel) {
  constexpr std::size_t piece = std::size_t{1} << 20;
  while (!bytes.empty()) {
    if (is_cancelled(cancel)) return ECANCELED;
    const ssize_t put = ::write(number, bytes.data(), std::min(piece, bytes.size()));
    if (put < 0 && errno != EINTR) return errno;
    if (put > 0) bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  return 0;
}

/// Writes to an opened file and closes it; a negative descriptor stands for errno. 0 or the error.
int write_and_close(int number, std::string_view bytes, const Cancel* cancel) {
  if (number < 0) return errno;
  Descriptor descriptor(number, true);
  const int code = write_all(descriptor.number(), bytes, cancel);
  return code != 0 ? code : descriptor.close();
}

/// A name in `directory` (empty or with its slash) that nobody else chooses.
std::string temporary_name(const std::string& directory) {
  static std::atomic<std::uint64_t> counter = 0;
  const auto now = std::chrono::system_clock::now().time_since_epoch().count();
  return directory + ".quoin-" + std::to_string(::getpid()) + "-" + std::to_string(now) + "-" +
         std::to_string(counter++) + ".tmp";
}

/// Writes a temporary file beside `path` and renames it. 0 or the error.
int replace(const std::string& path, std::string_view bytes, const Cancel* cancel) {
  const std::size_t slash = path.rfind('/');
  const std::string name = temporary_name(slash == std::string::npos ? std::string() : path.substr(0, slash + 1));
  const int number = open_retrying(name.c_str(), O_WRONLY | O_CREAT | O_EXCL, cancel);
  if (number < 0) return errno;

  int code = write_and_close(number, bytes, cancel);
  if (code == 0 && ::rename(name.c_str(), path.c_str()) != 0) code = errno;
  if (code != 0) (void)::unlink(name.c_str());
  return code;
}

/// Where a symbolic link leads, so that the link stays a link; other paths as they are.
std::string resolved(const std::string& path) {
  struct stat status;
  if (::lstat(path.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) return path;
  char* real = ::realpath(path.c_str(), nullptr);
  if (real == nullptr) return path;
  std::string result = real;
  std::free(real);
  return result;
}

}  // namespace

Result<std::string> read_file(const std::string& path) {
  const bool standard = path == "-";
  const Descriptor descriptor(standard ? STDIN_FILENO : open_retrying(path.c_str(), O_RDONLY), !standard);
  if (descriptor.number() < 0) return unreadable(path, errno);
  std::string bytes;
  if (const int code = read_all(descriptor.number(), bytes); code != 0) return unreadable(path, code);
  return bytes;
}

Result<void> write_file(const std::string& path, std::string_view bytes, const Cancel* cancel) {
  int code = 0;
  struct stat status;
  if (path == "-") {
    code = write_all(STDOUT_FILENO, bytes, cancel);
    // Devices and pipes cannot be replaced: they are written to.
  } else if (::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    code = S_ISDIR(status.st_mode) ? EISDIR
                                   : write_and_close(open_retrying(path.c_str(), O_WRONLY, cancel), bytes, cancel);
  } else {
    code = replace(resolved(path), bytes, cancel);
  }
  if (code != 0) return unwritable(path, code);
  return {};
}

}  // namespace quoin::io
