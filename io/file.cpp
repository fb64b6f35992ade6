// Whole files in and out. An output is written beside its path under a name of its own, then renamed; where that would
// part an existing file from its other names or its owner, it is written in place.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <string>
#include <system_error>

#include "io/mesh.h"
#include "io/too_large.h"

namespace quoin::io {
namespace {

std::string reason(int code) { return std::generic_category().message(code); }

/// What the system would take for the end of a name.
bool holds_zero(const std::string& path) { return path.find('\0') != std::string::npos; }

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

/// Whether a stream begins as no format does: a binary STL whose 80 bytes of header are 0 declares by 4 more zeros that
/// it has no facets, and has less than the 50 bytes of one behind them; no other format begins with a 0.
bool begins_with_nothing(std::string_view bytes) {
  constexpr std::size_t too_many_zeros = 84 + 50;
  return bytes.size() >= too_many_zeros && bytes.substr(0, too_many_zeros).find_first_not_of('\0') == bytes.npos;
}

/// All bytes to the end of the file; the size is a hint. A stream that no reader would take is not read to its end.
/// Errors: "unreadable", "too-large", "unknown-format".
Result<std::string> read_all(int number, const std::string& path, const Limits& limits) {
  constexpr std::size_t chunk = std::size_t{1} << 16;
  struct stat status;
  const bool regular = ::fstat(number, &status) == 0 && S_ISREG(status.st_mode);
  const std::uint64_t most = regular ? limits.bytes : limits.stream_bytes;
  const auto excess = [&] {
    Error error = too_large("the file has more bytes", regular ? "bytes" : "stream-bytes", most);
    error.file = path;
    return error;
  };
  if (regular && static_cast<std::uint64_t>(status.st_size) > most) return excess();

  // One byte more than the size lets the last read see the end without growing.
  std::string bytes(regular ? static_cast<std::size_t>(status.st_size) + 1 : chunk, '\0');
  std::size_t size = 0;
  for (;;) {
    if (size == bytes.size()) bytes.resize(bytes.size() + std::max(chunk, bytes.size()));
    const ssize_t got = ::read(number, bytes.data() + size, bytes.size() - size);
    if (got == 0) break;
    if (got > 0) size += static_cast<std::size_t>(got);
    if (size > most) return excess();
    if (!regular && begins_with_nothing({bytes.data(), size}))
      return Error{ErrorCode::unknown_format, "the stream begins with zero bytes, more of them than any format does",
                   path};
    if (got < 0 && errno != EINTR) return unreadable(path, errno);
  }
  bytes.resize(size);
  return bytes;
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

/// Has the system carry out what was written. 0 or the error; what cannot be synchronised need not be.
int synchronise(int number) {
  int result = 0;
  do result = ::fsync(number);
  while (result != 0 && errno == EINTR);
  return result == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS ? 0 : errno;
}

/// Writes to an opened pipe or device and closes it; a negative descriptor stands for errno. 0 or the error.
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

/// The folder of a path with its slash, or nothing.
std::string folder_of(const std::string& path) { return path.substr(0, path.rfind('/') + 1); }

/// Makes a name that a folder holds outlast a crash. Not every system can: then it may not.
void synchronise_folder(const std::string& path) {
  const std::string folder = folder_of(path);
  const Descriptor descriptor(open_retrying(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY), true);
  if (descriptor.number() >= 0) (void)synchronise(descriptor.number());
}

/// Gives a new file the owner, group and permissions of another one. Whether the system allows it.
bool adopt(int number, const struct stat& old) {
  struct stat made;
  if (::fstat(number, &made) != 0) return false;
  if ((made.st_uid != old.st_uid || made.st_gid != old.st_gid) && ::fchown(number, old.st_uid, old.st_gid) != 0)
    return false;
  return ::fchmod(number, old.st_mode & 07777) == 0;
}

constexpr int cannot_replace = -1;  // no errno

/// Writes a temporary file beside `path` and renames it. 0 or the error; `cannot_replace` where no such file can be
/// made that equals the old one but for its bytes.
/// Nothing allocates memory while the temporary file exists: a handler of exhausted memory may end the program.
int replace(const std::string& path, const struct stat* old, std::string_view bytes, const Cancel* cancel) {
  const std::string name = temporary_name(folder_of(path));
  const int number = open_retrying(name.c_str(), O_WRONLY | O_CREAT | O_EXCL, cancel);
  if (number < 0) return old != nullptr && (errno == EACCES || errno == EPERM) ? cannot_replace : errno;

  Descriptor descriptor(number, true);
  int code = old == nullptr || adopt(number, *old) ? 0 : cannot_replace;
  if (code == 0) code = write_all(number, bytes, cancel);
  if (code == 0) code = synchronise(number);
  if (code == 0) code = descriptor.close();
  if (code == 0 && ::rename(name.c_str(), path.c_str()) != 0) code = errno;
  if (code != 0)
    (void)::unlink(name.c_str());
  else
    synchronise_folder(path);
  return code;
}

/// Writes over an existing file. 0 or the error. Room is reserved first, and what has begun is not cancelled, so that
/// only a failing device or the end of the process leave a part.
int write_in_place(const std::string& path, const struct stat& old, std::string_view bytes, const Cancel* cancel) {
  const int number = open_retrying(path.c_str(), O_WRONLY, cancel);
  if (number < 0) return errno;
  Descriptor descriptor(number, true);

  const auto size = static_cast<off_t>(bytes.size());
  const int reserved = bytes.empty() ? 0 : ::posix_fallocate(number, 0, size);
  if (reserved == ENOSPC || reserved == EFBIG || reserved == EIO) {
    (void)!::ftruncate(number, old.st_size);
    return reserved;
  }

  if (is_cancelled(cancel)) {
    (void)!::ftruncate(number, old.st_size);
    return ECANCELED;
  }
  int code = write_all(number, bytes, nullptr);
  if (code == 0 && ::ftruncate(number, size) != 0) code = errno;
  if (code == 0) code = synchronise(number);
  return code != 0 ? code : descriptor.close();
}

/// Writes a new file, or over a regular one. 0 or the error.
int write_regular(const std::string& path, const struct stat* old, std::string_view bytes, const Cancel* cancel) {
  // Who may not write a file may not replace it: its permissions say so, though those of its folder do not.
  if (old != nullptr && ::access(path.c_str(), W_OK) != 0) return errno;
  const bool has_other_names = old != nullptr && old->st_nlink > 1;
  const int code = has_other_names ? cannot_replace : replace(path, old, bytes, cancel);
  return code == cannot_replace ? write_in_place(path, *old, bytes, cancel) : code;
}

/// Where symbolic links lead, so that they stay links, also to what does not exist yet.
std::string resolved(std::string path) {
  // As many links as systems follow.
  for (int links = 0; links < 40; ++links) {
    std::error_code not_a_link;
    const std::string target = std::filesystem::read_symlink(path, not_a_link).string();
    if (not_a_link) break;
    path = target.starts_with('/') ? target : folder_of(path) + target;
  }
  return path;
}

}  // namespace

Result<std::string> read_file(const std::string& path, const Limits& limits) {
  if (holds_zero(path)) return Error{ErrorCode::missing_file, "the name of a file holds a byte 0", path};
  const bool standard = path == "-";
  const Descriptor descriptor(standard ? STDIN_FILENO : open_retrying(path.c_str(), O_RDONLY), !standard);
  if (descriptor.number() < 0) return unreadable(path, errno);
  return read_all(descriptor.number(), path, limits);
}

Result<void> write_file(const std::string& path, std::string_view bytes, const Cancel* cancel) {
  if (holds_zero(path)) return Error{ErrorCode::unwritable, "the name of a file holds a byte 0", path};
  int code = 0;
  struct stat status;
  const bool exists = path != "-" && ::stat(path.c_str(), &status) == 0;
  if (path == "-")
    code = write_all(STDOUT_FILENO, bytes, cancel);
  else if (exists && S_ISDIR(status.st_mode))
    code = EISDIR;
  else if (exists && !S_ISREG(status.st_mode))  // devices and pipes cannot be replaced
    code = write_and_close(open_retrying(path.c_str(), O_WRONLY, cancel), bytes, cancel);
  else
    code = write_regular(resolved(path), exists ? &status : nullptr, bytes, cancel);
  if (code != 0) return unwritable(path, code);
  return {};
}

}  // namespace quoin::io
