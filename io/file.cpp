// Whole files in and out. An output is written beside its path under a name of its own, then renamed.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <system_error>

#include "io/mesh.h"

namespace quoin::io {
namespace {

#ifdef PATH_MAX
constexpr std::size_t max_path = PATH_MAX;
#else
constexpr std::size_t max_path = 4096;
#endif

/// Held during a write: there is one temporary file at a time.
std::mutex write_mutex;
/// The path of the temporary file, valid while the flag is set.
std::array<char, max_path> temporary_path;
std::atomic<bool> has_temporary = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only read lock-free atomics");

std::string reason(int code) { return std::generic_category().message(code); }

Error unreadable(const std::string& path, int code) {
  const bool missing = code == ENOENT || code == ENOTDIR;
  return Error{missing ? ErrorCode::missing_file : ErrorCode::unreadable, "cannot read the file: " + reason(code),
               path};
}

Error unwritable(const std::string& path, int code) {
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

int open_retrying(const char* path, int flags) {
  for (;;) {
    const int number = ::open(path, flags | O_CLOEXEC, 0666);
    if (number >= 0 || errno != EINTR) return number;
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

/// 0 or the error.
int write_all(int number, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(number, bytes.data(), bytes.size());
    if (put < 0 && errno != EINTR) return errno;
    if (put > 0) bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  return 0;
}

/// Writes to an opened file and closes it; a negative descriptor stands for errno. 0 or the error.
int write_and_close(int number, std::string_view bytes) {
  if (number < 0) return errno;
  Descriptor descriptor(number, true);
  const int code = write_all(descriptor.number(), bytes);
  return code != 0 ? code : descriptor.close();
}

/// A name in `directory` (empty or with its slash) that no other process chooses.
std::string temporary_name(const std::string& directory) {
  static std::atomic<std::uint64_t> counter = 0;
  const auto now = std::chrono::system_clock::now().time_since_epoch().count();
  return directory + ".quoin-" + std::to_string(::getpid()) + "-" + std::to_string(now) + "-" +
         std::to_string(counter++) + ".tmp";
}

/// Opens a new temporary file and leaves its path registered. Negative, with errno, when that fails.
/// Registering comes first: a signal between the two must not leave a file behind.
int open_temporary(const std::string& directory) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    const std::string name = temporary_name(directory);
    if (name.size() >= temporary_path.size()) {
      errno = ENAMETOOLONG;
      return -1;
    }
    std::memcpy(temporary_path.data(), name.c_str(), name.size() + 1);
    has_temporary.store(true);
    const int number = open_retrying(temporary_path.data(), O_WRONLY | O_CREAT | O_EXCL);
    if (number >= 0) return number;
    has_temporary.store(false);
    if (errno != EEXIST) return -1;
  }
  errno = EEXIST;
  return -1;
}

/// Writes a temporary file beside `path` and renames it. 0 or the error.
int replace(const std::string& path, std::string_view bytes) {
  const std::lock_guard<std::mutex> lock(write_mutex);
  const std::size_t slash = path.rfind('/');
  const int number = open_temporary(slash == std::string::npos ? std::string() : path.substr(0, slash + 1));
  if (number < 0) return errno;
  int code = write_and_close(number, bytes);
  if (code == 0 && ::rename(temporary_path.data(), path.c_str()) != 0) code = errno;
  if (code != 0) (void)::unlink(temporary_path.data());
  has_temporary.store(false);
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

Result<void> write_file(const std::string& path, std::string_view bytes) {
  int code = 0;
  struct stat status;
  if (path == "-") {
    code = write_all(STDOUT_FILENO, bytes);
    // Devices and pipes cannot be replaced: they are written to.
  } else if (::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    code = S_ISDIR(status.st_mode) ? EISDIR : write_and_close(open_retrying(path.c_str(), O_WRONLY), bytes);
  } else {
    code = replace(resolved(path), bytes);
  }
  if (code != 0) return unwritable(path, code);
  return {};
}

void abandon_temporary_files() {
  const int kept = errno;
  if (has_temporary.load()) (void)::unlink(temporary_path.data());
  errno = kept;
}

}  // namespace quoin::io
