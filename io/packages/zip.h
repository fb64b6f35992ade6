/// \file
/// ZIP archives in memory: what 3MF and AMF files are packed in. Compression is zlib's.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/result.h"

namespace quoin::io {

/// A file of an archive, as the archive's directory states it.
struct ZipEntry {
  std::string name;
  std::uint16_t method = 0;  // 0 stored, 8 deflated
  std::uint16_t flags = 0;
  std::uint32_t checksum = 0;
  std::uint64_t packed_size = 0, size = 0;
  std::uint64_t header = 0;  // where its local header begins
};

/// An archive and its directory; the bytes must outlive it.
class ZipArchive {
 public:
  /// What an archive may inflate to: so many times what is packed, beyond a first allowance, and so much in all.
  static constexpr std::uint64_t max_ratio = 256, allowance = std::uint64_t{1} << 20;
  static constexpr std::uint64_t max_size = std::uint64_t{1} << 34;

  static bool looks_like(std::string_view bytes) { return bytes.starts_with("PK\x03\x04"); }

  /// Reads the directory, also of ZIP64. Errors (with `where` = byte): "truncated" (no end of a directory),
  /// "bad-syntax", "absurd-count".
  static Result<ZipArchive> open(std::string_view bytes);

  const std::vector<ZipEntry>& entries() const { return entries_; }
  /// By name, ASCII letters of any case, as packages are read; a leading slash is passed over. nullptr for none.
  const ZipEntry* find(std::string_view name) const;

  /// The content of an entry. Errors (with `where` = the entry's name): "truncated", "bad-syntax" (a wrong checksum or
  /// size, encryption, another method than deflate), "absurd-count" (more than the limits above).
  Result<std::string> content(const ZipEntry& entry) const;

 private:
  std::string_view bytes_;
  std::vector<ZipEntry> entries_;
};

/// What is packed into an archive.
struct ZipFile {
  std::string name;
  std::string content;
};

/// An archive of deflated files, without times: equal files give equal bytes. Numbers that 32 bits, or counts that 16,
/// do not hold are written as ZIP64.
std::string write_zip(const std::vector<ZipFile>& files);

/// Its records: what stands before the content of an entry, its entry in the directory, and what stands behind a
/// directory of so many entries and bytes that begins there.
std::string zip_local_header(const ZipEntry& entry);
std::string zip_directory_entry(const ZipEntry& entry);
std::string zip_end(std::uint64_t count, std::uint64_t begin, std::uint64_t size);

}  // namespace quoin::io
