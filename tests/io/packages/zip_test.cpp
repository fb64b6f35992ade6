#include "io/packages/zip.h"

#include <array>

#include <zlib.h>

#include "tests/io/io_support.h"

namespace quoin::io {
namespace {

std::string content_of(const std::string& bytes, const char* name) {
  const auto archive = ZipArchive::open(bytes);
  if (!archive) return to_string(archive.error().code);
  const ZipEntry* entry = archive.value().find(name);
  if (entry == nullptr) return "none";
  const auto content = archive.value().content(*entry);
  if (content && content.value().size() > 10000000) return "large";  // a failure prints what is compared
  return content ? content.value() : to_string(content.error().code);
}

std::string word(std::uint64_t value, int size) {
  std::string out;
  for (int i = 0; i < size; ++i) out.push_back(i < 8 ? static_cast<char>(value >> (8 * i) & 0xff) : '\0');
  return out;
}

/// An archive of one stored file "a" by hand, in the form of ZIP64: its sizes and place stand in extra fields.
std::string wide_archive(const std::string& content) {
  const auto sum = ::crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size()));
  const std::string sizes = word(sum, 4) + word(0xffffffff, 4) + word(0xffffffff, 4) + word(1, 2);
  const std::string local = "PK\x03\x04" + word(45, 2) + word(0, 8) + sizes + word(20, 2) + "a" + word(1, 2) +
                            word(16, 2) + word(content.size(), 8) + word(content.size(), 8);
  const std::string central = "PK\x01\x02" + word(45, 2) + word(45, 2) + word(0, 8) + sizes + word(28, 2) +
                              word(0, 10) + word(0xffffffff, 4) + "a" + word(1, 2) + word(24, 2) +
                              word(content.size(), 8) + word(content.size(), 8) + word(0, 8);
  const std::uint64_t begin = local.size() + content.size(), end = begin + central.size();
  const std::string end64 = "PK\x06\x06" + word(44, 8) + word(45, 4) + word(0, 8) + word(1, 8) + word(1, 8) +
                            word(central.size(), 8) + word(begin, 8);
  const std::string locator = "PK\x06\x07" + word(0, 4) + word(end, 8) + word(1, 4);
  return local + content + central + end64 + locator + "PK\x05\x06" + word(0, 4) + word(0xffff, 2) + word(0xffff, 2) +
         word(0xffffffff, 4) + word(0xffffffff, 4) + word(0, 2);
}

TEST(Zip, WhatIsWrittenIsRead) {
  std::mt19937_64 random(test::seed());
  std::string noise, long_text;
  for (int i = 0; i < 100000; ++i) noise.push_back(static_cast<char>(random()));
  for (std::uint64_t i = 0; i < 60000; ++i) long_text += std::to_string(i * i);
  const std::string bytes = write_zip({{"a", "first"}, {"Folder/b.txt", long_text}, {"noise", noise}, {"empty", ""}});
  EXPECT_EQ(bytes, write_zip({{"a", "first"}, {"Folder/b.txt", long_text}, {"noise", noise}, {"empty", ""}}));
  EXPECT_EQ(content_of(bytes, "a"), "first");
  EXPECT_EQ(content_of(bytes, "/folder/B.TXT"), long_text);
  EXPECT_EQ(content_of(bytes, "noise"), noise);
  EXPECT_EQ(content_of(bytes, "empty"), "");
  EXPECT_EQ(content_of(bytes, "c"), "none");
  EXPECT_EQ(content_of(bytes + std::string(1000, 'x'), "a"), "first");  // a comment behind it
}

TEST(Zip, NumbersOfZip64) { EXPECT_EQ(content_of(wide_archive("wide and stored"), "a"), "wide and stored"); }

// The records of what would be larger than 4 GiB, by hand; the directory is read back.
TEST(Zip, WideRecords) {
  constexpr std::uint64_t gib = std::uint64_t{1} << 30;
  const ZipEntry wide{"a", 8, 0x800, 7, 5 * gib, 6 * gib, 7 * gib};
  const std::string common = word(0x800, 2) + word(8, 2) + word(0, 2) + word(0x21, 2) + word(7, 4);
  const std::string hidden = word(0xffffffff, 4) + word(0xffffffff, 4) + word(1, 2);
  EXPECT_EQ(zip_local_header(wide), "PK\x03\x04" + word(45, 2) + common + hidden + word(20, 2) + "a" + word(1, 2) +
                                        word(16, 2) + word(6 * gib, 8) + word(5 * gib, 8));
  EXPECT_EQ(zip_directory_entry(wide), "PK\x01\x02" + word(45, 2) + word(45, 2) + common + hidden + word(28, 2) +
                                           word(0, 10) + word(0xffffffff, 4) + "a" + word(1, 2) + word(24, 2) +
                                           word(6 * gib, 8) + word(5 * gib, 8) + word(7 * gib, 8));
  // A number alone that is wide.
  const ZipEntry far{"b", 8, 0x800, 7, 9, 10, 7 * gib};
  EXPECT_EQ(zip_local_header(far),
            "PK\x03\x04" + word(20, 2) + common + word(9, 4) + word(10, 4) + word(1, 2) + word(0, 2) + "b");
  EXPECT_EQ(zip_directory_entry(far), "PK\x01\x02" + word(45, 2) + word(45, 2) + common + word(9, 4) + word(10, 4) +
                                          word(1, 2) + word(12, 2) + word(0, 10) + word(0xffffffff, 4) + "b" +
                                          word(1, 2) + word(8, 2) + word(7 * gib, 8));

  const std::string directory = zip_directory_entry(wide) + zip_directory_entry(far);
  const auto archive = ZipArchive::open(directory + zip_end(2, 0, directory.size()));
  ASSERT_TRUE(archive) << archive.error().message;
  ASSERT_EQ(archive.value().entries().size(), 2U);
  const auto numbers = [](const ZipEntry& entry) { return std::array{entry.packed_size, entry.size, entry.header}; };
  EXPECT_EQ(numbers(archive.value().entries()[0]), numbers(wide));
  EXPECT_EQ(numbers(archive.value().entries()[1]), numbers(far));
}

// One that is counted, begins or is large beyond what the plain end holds.
TEST(Zip, WideEnds) {
  const auto wide = [](std::uint64_t count, std::uint64_t begin, std::uint64_t size) {
    return "PK\x06\x06" + word(44, 8) + word(45, 2) + word(45, 2) + word(0, 8) + word(count, 8) + word(count, 8) +
           word(size, 8) + word(begin, 8) + "PK\x06\x07" + word(0, 4) + word(begin + size, 8) + word(1, 4);
  };
  const auto plain = [](std::uint64_t count, std::uint64_t begin, std::uint64_t size) {
    return "PK\x05\x06" + word(0, 4) + word(count, 2) + word(count, 2) + word(size, 4) + word(begin, 4) + word(0, 2);
  };
  constexpr std::uint64_t most = 0xffffffff;
  EXPECT_EQ(zip_end(3, 4, 5), plain(3, 4, 5));
  EXPECT_EQ(zip_end(0xfffe, most - 1, most - 1), plain(0xfffe, most - 1, most - 1));
  EXPECT_EQ(zip_end(0xffff, 4, 5), wide(0xffff, 4, 5) + plain(0xffff, 4, 5));
  EXPECT_EQ(zip_end(3, most, 5), wide(3, most, 5) + plain(3, most, 5));
  EXPECT_EQ(zip_end(3, most * 4, 5), wide(3, most * 4, 5) + plain(3, most, 5));
  EXPECT_EQ(zip_end(3, 4, most * 2), wide(3, 4, most * 2) + plain(3, 4, most));
}

// More entries than 16 bits count.
TEST(Zip, ManyEntries) {
  std::vector<ZipFile> files;
  for (int i = 0; i < 70000; ++i) files.push_back({std::to_string(i), ""});
  const std::string bytes = write_zip(files);
  EXPECT_EQ(ZipArchive::open(bytes).value().entries().size(), files.size());
  EXPECT_EQ(content_of(bytes, "69999"), "");
}

// A prefix has no directory at its end; a change of any byte changes nothing, is noticed, or hides the entry.
TEST(Zip, DamageIsNoticed) {
  const std::string good = write_zip({{"a", "some text that is long enough, long enough, long enough"}});
  for (std::size_t size = 0; size < good.size(); ++size)
    EXPECT_EQ(content_of(good.substr(0, size), "a"), "truncated") << size;
  const std::string text = content_of(good, "a");
  for (std::size_t i = 0; i < good.size(); ++i)
    for (const char flip : {'\x01', '\x40', '\xff'}) {
      std::string bad = good;
      bad[i] = static_cast<char>(bad[i] ^ flip);
      const std::string found = content_of(bad, "a");
      EXPECT_TRUE(found == text || found == "truncated" || found == "bad-syntax" || found == "absurd-count" ||
                  found == "none")
          << i << " " << found;
    }
}

// 100 MB of zeros in 100 KB: more than 256 times what is packed.
TEST(Zip, BombsAreRefusedBeforeTheyUnfold) {
  const std::string bomb = write_zip({{"a", std::string(100000000, '\0')}});
  EXPECT_LT(bomb.size(), 200000U);
  EXPECT_EQ(content_of(bomb, "a"), "absurd-count");
  // A small one that claims less than it holds is unpacked no further than its claim.
  std::string liar = write_zip({{"a", std::string(1000000, '\0')}});
  for (const char* signature : {"PK\x03\x04", "PK\x01\x02"}) {
    const std::size_t at = liar.find(signature) + (signature[2] == 3 ? 22 : 24);
    liar.replace(at, 4, word(1000, 4));
  }
  EXPECT_EQ(content_of(liar, "a"), "bad-syntax");
}

}  // namespace
}  // namespace quoin::io
