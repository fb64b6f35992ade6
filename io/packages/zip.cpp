#include "io/packages/zip.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <memory>

#include <zlib.h>

namespace quoin::io {
namespace {

constexpr std::uint64_t local_size = 30, central_size = 46, end_size = 22, locator_size = 20, end64_size = 56;
/// In place of a number that stands in an extra field.
constexpr std::uint32_t narrow = std::numeric_limits<std::uint32_t>::max();

/// Little-endian numbers at a place of the bytes. Precondition: they are there.
std::uint64_t number_at(std::string_view bytes, std::uint64_t at, int size) {
  std::uint64_t value = 0;
  for (int i = size - 1; i >= 0; --i)
    value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::uint64_t>(i)]);
  return value;
}

bool has(std::string_view bytes, std::uint64_t at, std::uint64_t size) {
  return at <= bytes.size() && size <= bytes.size() - at;
}

bool shows(std::string_view bytes, std::uint64_t at, std::string_view signature) {
  return has(bytes, at, signature.size()) && bytes.substr(at, signature.size()) == signature;
}

Error damaged(ErrorCode code, const std::string& what, std::uint64_t at) {
  return {code, "the archive " + what, {}, "byte " + std::to_string(at)};
}

struct Directory {
  std::uint64_t begin = 0, count = 0;
};

/// The numbers of ZIP64 where the end of the directory does not hold them.
Result<Directory> wide_directory(std::string_view bytes, std::uint64_t end) {
  const std::uint64_t locator = end - locator_size;
  if (end < locator_size || !shows(bytes, locator, "PK\x06\x07"))
    return damaged(ErrorCode::bad_syntax, "lacks the end of its ZIP64 directory", end);
  const std::uint64_t at = number_at(bytes, locator + 8, 8);
  if (!has(bytes, at, end64_size) || !shows(bytes, at, "PK\x06\x06"))
    return damaged(ErrorCode::bad_syntax, "has no ZIP64 directory where it says", locator);
  return Directory{number_at(bytes, at + 48, 8), number_at(bytes, at + 32, 8)};
}

/// A comment of at most 64 KiB may stand behind the end of the directory.
Result<Directory> directory_of(std::string_view bytes) {
  const std::uint64_t first = bytes.size() - std::min<std::uint64_t>(bytes.size(), end_size + 0xffff);
  const std::size_t end = bytes.rfind("PK\x05\x06");
  if (end == std::string_view::npos || end < first || !has(bytes, end, end_size))
    return damaged(ErrorCode::truncated, "has no directory at its end", bytes.size());

  const Directory directory{number_at(bytes, end + 16, 4), number_at(bytes, end + 10, 2)};
  const bool is_wide = directory.begin == narrow || directory.count == 0xffff;
  return is_wide ? wide_directory(bytes, end) : directory;
}

/// Replaces the numbers that an entry of ZIP64 states in its extra field, in their order.
void widen(ZipEntry& entry, std::string_view extra) {
  std::uint64_t at = 0;
  while (has(extra, at, 4)) {
    const std::uint64_t kind = number_at(extra, at, 2), size = number_at(extra, at + 2, 2);
    std::uint64_t from = at + 4;
    at = from + size;
    if (kind != 1) continue;
    for (std::uint64_t* number : {&entry.size, &entry.packed_size, &entry.header}) {
      if (*number != narrow || !has(extra, from, 8) || from + 8 > at) continue;
      *number = number_at(extra, from, 8);
      from += 8;
    }
  }
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_name(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char c, char d) { return lower(c) == lower(d); });
}

std::string_view without_slash(std::string_view name) { return name.starts_with('/') ? name.substr(1) : name; }

Error unfit(ErrorCode code, const ZipEntry& entry, std::string message) {
  return {code, std::move(message), {}, entry.name};
}

std::uint32_t checksum_of(std::string_view bytes) {
  // zlib counts in 32 bits.
  constexpr std::size_t piece = std::size_t{1} << 30;
  uLong sum = ::crc32(0, nullptr, 0);
  for (; !bytes.empty(); bytes.remove_prefix(std::min(piece, bytes.size())))
    sum = ::crc32(sum, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(std::min(piece, bytes.size())));
  return static_cast<std::uint32_t>(sum);
}

/// Inflates into exactly `size` bytes; false where the packed bytes are something else.
bool inflated(std::string_view packed, std::string& out, std::uint64_t size) {
  constexpr std::uint64_t piece = std::uint64_t{1} << 20;
  z_stream stream = {};
  if (::inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_stream*)> guard(&stream, ::inflateEnd);

  // It grows with what comes: what a damaged entry declares is not allocated. One byte more shows what is too long.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  std::uint64_t fed = 0, made = 0;
  int code = Z_OK;
  while (code == Z_OK) {
    if (stream.avail_in == 0) {
      stream.avail_in = static_cast<uInt>(std::min(piece, packed.size() - fed));
      fed += stream.avail_in;
    }
    const std::uint64_t room = std::min(size + 1 - made, std::max(piece, made / 2));
    out.resize(made + room);
    stream.next_out = reinterpret_cast<Bytef*>(out.data() + made);
    stream.avail_out = static_cast<uInt>(std::min<std::uint64_t>(room, narrow));
    const uInt before = stream.avail_out;
    code = ::inflate(&stream, Z_NO_FLUSH);
    if (code == Z_MEM_ERROR) throw std::bad_alloc();
    made += before - stream.avail_out;
    if (made > size) return false;
  }
  out.resize(made);
  return code == Z_STREAM_END && made == size;
}

std::string deflated(std::string_view content) {
  // zlib counts in 32 bits.
  constexpr std::size_t in_piece = std::size_t{1} << 30, out_piece = std::size_t{1} << 20;
  z_stream stream = {};
  if (::deflateInit2(&stream, 6, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY) != Z_OK) throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_stream*)> guard(&stream, ::deflateEnd);

  std::string out;
  std::size_t made = 0;
  for (int code = Z_OK; code != Z_STREAM_END;) {
    if (stream.avail_in == 0) {
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
      stream.avail_in = static_cast<uInt>(std::min(in_piece, content.size()));
      content.remove_prefix(stream.avail_in);
    }
    out.resize(std::max(out.size(), made + out_piece));
    stream.next_out = reinterpret_cast<Bytef*>(out.data() + made);
    stream.avail_out = static_cast<uInt>(out_piece);
    code = ::deflate(&stream, content.empty() ? Z_FINISH : Z_NO_FLUSH);
    assert(code == Z_OK || code == Z_STREAM_END);
    made += out_piece - stream.avail_out;
  }
  out.resize(made);
  return out;
}

/// Little-endian, in at most 8 bytes.
void append(std::string& out, std::uint64_t value, int size) {
  for (int i = 0; i < size; ++i) out.push_back(static_cast<char>(value >> (8 * i) & 0xff));
}

constexpr int plain_version = 20, wide_version = 45;  // of the reader that is needed, in tenths

/// Whether a number stands in an extra field of ZIP64.
bool is_wide(std::uint64_t number) { return number >= narrow; }

void append_narrow(std::string& out, std::uint64_t number) { append(out, is_wide(number) ? narrow : number, 4); }

/// The extra field of ZIP64 with those numbers; empty for none.
std::string wide_field(const std::vector<std::uint64_t>& numbers) {
  std::string out;
  if (numbers.empty()) return out;
  append(out, 1, 2);
  append(out, 8 * numbers.size(), 2);
  for (const std::uint64_t number : numbers) append(out, number, 8);
  return out;
}

/// What the local header and the directory say alike: version, flags, method, a time (1980-01-01), sizes, name.
void append_header(std::string& out, const ZipEntry& entry, std::string_view field) {
  append(out, field.empty() ? plain_version : wide_version, 2);
  append(out, entry.flags, 2);
  append(out, entry.method, 2);
  append(out, 0, 2);
  append(out, 0x21, 2);
  append(out, entry.checksum, 4);
  append_narrow(out, entry.packed_size);
  append_narrow(out, entry.size);
  append(out, entry.name.size(), 2);
  append(out, field.size(), 2);
}

}  // namespace

Result<ZipArchive> ZipArchive::open(std::string_view bytes) {
  const auto directory = directory_of(bytes);
  if (!directory) return directory.error();
  const auto [begin, count] = directory.value();
  if (count > bytes.size() / central_size)
    return damaged(ErrorCode::absurd_count, "is too short for " + std::to_string(count) + " entries", begin);

  ZipArchive archive;
  archive.bytes_ = bytes;
  std::uint64_t at = begin;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (!has(bytes, at, central_size)) return damaged(ErrorCode::truncated, "ends within its directory", at);
    if (!shows(bytes, at, "PK\x01\x02")) return damaged(ErrorCode::bad_syntax, "has a damaged directory", at);
    const std::uint64_t name = number_at(bytes, at + 28, 2), extra = number_at(bytes, at + 30, 2),
                        comment = number_at(bytes, at + 32, 2);
    const std::uint64_t next = at + central_size + name + extra + comment;
    if (next > bytes.size()) return damaged(ErrorCode::truncated, "ends within its directory", at);

    ZipEntry entry;
    entry.name = bytes.substr(at + central_size, name);
    entry.flags = static_cast<std::uint16_t>(number_at(bytes, at + 8, 2));
    entry.method = static_cast<std::uint16_t>(number_at(bytes, at + 10, 2));
    entry.checksum = static_cast<std::uint32_t>(number_at(bytes, at + 16, 4));
    entry.packed_size = number_at(bytes, at + 20, 4);
    entry.size = number_at(bytes, at + 24, 4);
    entry.header = number_at(bytes, at + 42, 4);
    widen(entry, bytes.substr(at + central_size + name, extra));
    archive.entries_.push_back(std::move(entry));
    at = next;
  }
  return archive;
}

const ZipEntry* ZipArchive::find(std::string_view name) const {
  const std::string_view wanted = without_slash(name);
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const ZipEntry& entry) { return same_name(without_slash(entry.name), wanted); });
  return found == entries_.end() ? nullptr : &*found;
}

Result<std::string> ZipArchive::content(const ZipEntry& entry) const {
  if ((entry.flags & 1) != 0) return unfit(ErrorCode::bad_syntax, entry, "this part of the archive is encrypted");
  if (entry.method != 0 && entry.method != 8)
    return unfit(ErrorCode::bad_syntax, entry, "this part of the archive is packed by another method than deflate");
  if (!shows(bytes_, entry.header, "PK\x03\x04") || !has(bytes_, entry.header, local_size))
    return unfit(ErrorCode::truncated, entry, "this part is not where the archive's directory says");

  const std::uint64_t begin =
      entry.header + local_size + number_at(bytes_, entry.header + 26, 2) + number_at(bytes_, entry.header + 28, 2);
  if (!has(bytes_, begin, entry.packed_size))
    return unfit(ErrorCode::truncated, entry, "the archive ends within this part");
  if (entry.size > max_size || entry.size / max_ratio > entry.packed_size + allowance / max_ratio)
    return unfit(ErrorCode::absurd_count, entry,
                 "this part of the archive claims " + std::to_string(entry.size) + " bytes, packed in " +
                     std::to_string(entry.packed_size) + ": a mesh is never so regular");

  const std::string_view packed = bytes_.substr(begin, entry.packed_size);
  std::string content;
  if (entry.method == 0) content = packed;
  if (entry.method == 8 && !inflated(packed, content, entry.size))
    return unfit(ErrorCode::bad_syntax, entry, "this part of the archive cannot be unpacked: it is damaged");
  if (content.size() != entry.size || checksum_of(content) != entry.checksum)
    return unfit(ErrorCode::bad_syntax, entry, "the checksum of this part of the archive is wrong: it is damaged");
  return content;
}

std::string zip_local_header(const ZipEntry& entry) {
  // Where one of the sizes is wide both stand in the field.
  ZipEntry shown = entry;
  std::vector<std::uint64_t> wide;
  if (is_wide(entry.size) || is_wide(entry.packed_size)) {
    shown.size = shown.packed_size = narrow;
    wide = {entry.size, entry.packed_size};
  }
  const std::string field = wide_field(wide);

  std::string out = "PK\x03\x04";
  append_header(out, shown, field);
  return out + entry.name + field;
}

std::string zip_directory_entry(const ZipEntry& entry) {
  // The numbers that are wide, in this order.
  std::vector<std::uint64_t> wide;
  for (const std::uint64_t number : {entry.size, entry.packed_size, entry.header})
    if (is_wide(number)) wide.push_back(number);
  const std::string field = wide_field(wide);

  std::string out = "PK\x01\x02";
  append(out, field.empty() ? plain_version : wide_version, 2);
  append_header(out, entry, field);
  out.append(10, '\0');  // comment, disk, attributes
  append_narrow(out, entry.header);
  return out + entry.name + field;
}

std::string zip_end(std::uint64_t count, std::uint64_t begin, std::uint64_t size) {
  constexpr std::uint64_t narrow_count = 0xffff;
  std::string out;
  if (count >= narrow_count || is_wide(begin) || is_wide(size)) {
    out += "PK\x06\x06";
    append(out, end64_size - 12, 8);  // of what follows
    append(out, wide_version, 2);
    append(out, wide_version, 2);
    append(out, 0, 8);  // disks
    append(out, count, 8);
    append(out, count, 8);
    append(out, size, 8);
    append(out, begin, 8);
    out += "PK\x06\x07";
    append(out, 0, 4);
    append(out, begin + size, 8);
    append(out, 1, 4);
  }

  out += "PK\x05\x06";
  append(out, 0, 4);
  append(out, std::min(count, narrow_count), 2);
  append(out, std::min(count, narrow_count), 2);
  append_narrow(out, size);
  append_narrow(out, begin);
  append(out, 0, 2);
  return out;
}

std::string write_zip(const std::vector<ZipFile>& files) {
  std::string out, directory;
  for (const ZipFile& file : files) {
    const std::string packed = deflated(file.content);
    const ZipEntry entry{file.name,           8,         0x800, checksum_of(file.content), packed.size(),
                         file.content.size(), out.size()};
    out += zip_local_header(entry);
    out += packed;
    directory += zip_directory_entry(entry);
  }
  const std::uint64_t begin = out.size();
  return out + directory + zip_end(files.size(), begin, directory.size());
}

}  // namespace quoin::io
