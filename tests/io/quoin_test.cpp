#include "io/quoin.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <utility>

#include "tests/io/exact_document.h"
#include "tests/io/io_support.h"

namespace quoin::io {
namespace {

using test::ExactDocument;
using test::read_quoin;
using test::write_quoin;
using Record = ExactDocument::Record;
using Texts = std::vector<std::string>;

// A pinched, slit and dotted face, a derived vertex, numbers longer than a machine word; no solid.
const std::string small =
    "quoin 1\n"
    "grid 1/1000 -5/7 0 123456789012345678901234567890\n"
    "infinity full\n"
    "vertices 4\n"
    "0 0 0\n"
    "-340282366920938463463374607431768211456 0 9 10\n"
    "536870912 -536870912 1\n"
    "1 1 1 3\n"
    "faces 2\n"
    "-1 0 0 -4611686018427387903 3\n"
    "0 1 2 1 3\n"
    "3\n"
    "1 3\n"
    "0 0 1 0 1\n"
    "2 1 0\n"
    "end\n";

ExactDocument small_document() {
  ExactDocument document;
  document.step = "1/1000";
  document.origin = {"-5/7", "0", "123456789012345678901234567890"};
  document.full_at_infinity = true;
  document.vertices = {Record{"0", "0", "0", "1"}, Record{"-340282366920938463463374607431768211456", "0", "9", "10"},
                       Record{"536870912", "-536870912", "1", "1"}, Record{"1", "1", "1", "3"}};
  document.planes = {Record{"-1", "0", "0", "-4611686018427387903"}, Record{"0", "0", "1", "0"}};
  document.face_loops = {0, 3, 4};
  document.loop_corners = {0, 5, 6, 8, 11};
  document.corners = {0, 1, 2, 1, 3, 3, 1, 3, 2, 1, 0};
  return document;
}

/// The text without comment lines and carriage returns before line ends: what the reader may pass over.
std::string stripped(const std::string& text) {
  std::istringstream lines(text);
  std::string result, line;
  while (std::getline(lines, line)) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty() || line[0] != '#') result += line + "\n";
  }
  return result;
}

/// The error as "line N: message", "" when the text was read; checks what both cases promise.
std::string refusal(std::string_view text) {
  // A copy of exact size, so that the sanitizer sees a read behind the end.
  const std::vector<char> copy(text.begin(), text.end());
  const Result<io::ExactDocument> read = io::read_quoin(std::string_view(copy.data(), copy.size()));
  if (!read) {
    EXPECT_EQ(read.error().code, ErrorCode::bad_quoin);
    EXPECT_EQ(read.error().where.rfind("line ", 0), 0U);
    EXPECT_FALSE(read.error().message.empty());
    return read.error().where + ": " + read.error().message;
  }
  const io::ExactDocument& document = read.value();
  EXPECT_EQ(io::write_quoin(document), stripped(std::string(text)));
  for (const std::uint32_t corner : document.corners) EXPECT_LT(corner, document.vertices.size());
  const std::size_t allocated =
      (document.vertices.capacity() + document.planes.capacity()) * sizeof document.vertices[0] +
      (document.face_loops.capacity() + document.loop_corners.capacity() + document.corners.capacity()) * 4;
  EXPECT_LE(allocated, 64 + 64 * text.size());
  return "";
}

/// Refused at that line, for a reason that holds these words.
void expect_refused(const std::string& text, std::size_t line, const std::string& words) {
  const std::string found = refusal(text);
  EXPECT_EQ(found.rfind("line " + std::to_string(line) + ": ", 0), 0U) << found << "\n" << text.substr(0, 2000);
  EXPECT_NE(found.find(words), std::string::npos) << found << "\n" << text.substr(0, 2000);
}

/// The small text with its one occurrence of `old_line` replaced.
std::string with_line(const std::string& old_line, const std::string& new_line) {
  const std::size_t at = small.find("\n" + old_line + "\n");
  EXPECT_NE(at, std::string::npos) << old_line;
  EXPECT_EQ(small.find("\n" + old_line + "\n", at + 1), std::string::npos) << old_line;
  return small.substr(0, at + 1) + new_line + small.substr(at + 1 + old_line.size());
}

std::string random_integer(std::mt19937_64& random, std::size_t max_digits) {
  const std::size_t digits = random() % 3 == 0 ? random() % max_digits + 1 : random() % 3 + 1;
  std::string result(1, static_cast<char>('1' + random() % 9));
  while (result.size() < digits) result.push_back(static_cast<char>('0' + random() % 10));
  if (random() % 5 == 0) return "0";
  return (random() % 2 == 0 ? "-" : "") + result;
}

std::string random_positive(std::mt19937_64& random, std::size_t max_digits) {
  for (;;) {
    std::string result = random_integer(random, max_digits);
    if (result[0] != '-' && result != "0") return result;
  }
}

std::string random_rational(std::mt19937_64& random) {
  std::string p = random_integer(random, max_lattice_digits);
  const std::string q = random_positive(random, max_lattice_digits);
  return p == "0" || q == "1" ? p : p + "/" + q;
}

ExactDocument random_document(std::mt19937_64& random) {
  ExactDocument document;
  document.step = random_positive(random, max_lattice_digits);
  for (std::string& coordinate : document.origin) coordinate = random_rational(random);
  document.full_at_infinity = random() % 2 == 0;
  const auto coordinate = [&] { return random_integer(random, max_coordinate_digits); };
  const auto coefficient = [&] { return random_integer(random, max_coefficient_digits); };
  for (std::uint64_t i = random() % 30 + 1; i > 0; --i) {
    document.vertices.push_back(
        {coordinate(), coordinate(), coordinate(), random_positive(random, max_coordinate_digits)});
  }
  for (std::uint64_t i = random() % 20; i > 0; --i) {
    document.planes.push_back({coefficient(), coefficient(), coefficient(), coefficient()});
    for (std::uint64_t loops = random() % 3 + 1; loops > 0; --loops) {
      for (std::uint64_t k = random() % 6 + 1; k > 0; --k) {
        document.corners.push_back(static_cast<std::uint32_t>(random() % document.vertices.size()));
      }
      document.loop_corners.push_back(static_cast<std::uint32_t>(document.corners.size()));
    }
    document.face_loops.push_back(static_cast<std::uint32_t>(document.loop_corners.size() - 1));
  }
  return document;
}

TEST(Quoin, WritesAndReadsAsDocumented) {
  EXPECT_EQ(write_quoin(small_document()), small);
  const Result<ExactDocument> read = read_quoin(small);
  ASSERT_TRUE(read) << read.error().where << read.error().message;
  EXPECT_TRUE(read.value() == small_document());
  EXPECT_EQ(write_quoin(ExactDocument()), "quoin 1\ngrid 1 0 0 0\ninfinity empty\nvertices 0\nfaces 0\nend\n");
  EXPECT_TRUE(read_quoin(write_quoin(ExactDocument())).value() == ExactDocument());
}

TEST(Quoin, RandomDocumentsRoundTrip) {
  std::mt19937_64 random(test::seed());
  for (int round = 0; round < 500; ++round) {
    const ExactDocument document = random_document(random);
    const std::string text = write_quoin(document);
    EXPECT_EQ(text, write_quoin(ExactDocument(document)));
    const Result<ExactDocument> read = read_quoin(text);
    ASSERT_TRUE(read) << read.error().where << read.error().message << "\n" << text;
    ASSERT_TRUE(read.value() == document) << text;
  }
}

TEST(Quoin, TellsItsFiles) {
  EXPECT_TRUE(looks_like_quoin(small));
  EXPECT_TRUE(looks_like_quoin("quoin 2\n"));
  for (const char* other : {"", "quoin", "quoins 1\n", " quoin 1\n", "Quoin 1\n", "ply\n", "solid quoin 1\n"}) {
    EXPECT_FALSE(looks_like_quoin(other)) << other;
    expect_refused(other, 1, "no .quoin file");
  }
  for (const char* other : {"quoin 2\n", "quoin 10\n", "quoin 1.0\n", "quoin 1 \n", "quoin \n", "quoin 01\n"}) {
    expect_refused(other, 1, "version");
  }
  expect_refused("#comment\n" + small, 1, "no .quoin file");
  expect_refused("\xEF\xBB\xBF" + small, 1, "no .quoin file");
}

TEST(Quoin, CarriageReturnsAndComments) {
  EXPECT_EQ(refusal(test::with_crlf(small)), "");
  std::string commented;
  for (const char c : small.substr(0, small.size() - 4)) {
    commented += c == '\n' ? "\n#\n# 1 2 3 \xC3\xA9 \r # end\r\n#end\n" : std::string(1, c);
  }
  EXPECT_EQ(refusal(commented + "end\n"), "");
  EXPECT_EQ(refusal(commented + "end\r\n"), "");
  EXPECT_TRUE(read_quoin(commented + "end\r\n").value() == small_document());
  expect_refused(commented + "end \n", 61, "\"end\"");
  expect_refused(with_line("0 0 0", "0 0 0 # here"), 5, "integer");
  expect_refused(with_line("0 0 0", " # here\n0 0 0"), 5, "integer");
  expect_refused(with_line("0 0 0", "0 0\r 0"), 5, "character");
  expect_refused(with_line("0 0 0", "0 0 0\r\r"), 5, "character");
}

TEST(Quoin, Lattices) {
  const auto grid = [](const std::string& line) { return with_line(small.substr(8, small.find('\n', 8) - 8), line); };
  const std::string longest(max_lattice_digits, '9');
  for (const std::string& good : Texts{"1 0 0 0", "1/2 -1/2 -3 3/2", longest + "/" + longest + " 0 0 -" + longest}) {
    EXPECT_EQ(refusal(grid("grid " + good)), "") << good;
  }
  for (const std::string& step : Texts{"0", "-1", "-1/2"})
    expect_refused(grid("grid " + step + " 0 0 0"), 2, "positive");
  for (const std::string& bad : Texts{"1/1", "1/0", "0/2", "1/-2"}) {
    expect_refused(grid("grid " + bad + " 0 0 0"), 2, "rational");
    expect_refused(grid("grid 1 0 0 " + bad), 2, "rational");
  }
  for (const std::string& bad : Texts{"1/", "/2", "1/02", "-0", "00", "+1", "0.5", "1e3", "1/2/3", "0x1", "1/-0"}) {
    EXPECT_NE(refusal(grid("grid " + bad + " 0 0 0")), "") << bad;
    EXPECT_NE(refusal(grid("grid 1 0 " + bad + " 0")), "") << bad;
  }
  expect_refused(grid("grid 1" + longest + " 0 0 0"), 2, "digits");
  expect_refused(grid("grid 1 0 0 1/1" + longest), 2, "digits");
  expect_refused(grid("grid 1 0 0"), 2, "expected");
  expect_refused(grid("grid 1 0 0 0 0"), 2, "too many");
  for (const std::string& bad :
       Texts{"grid", "grid ", "grid  1 0 0 0", " grid 1 0 0 0", "grid 1 0 0 0 ", "", "Grid 1 0 0 0", "grid1 0 0 0"}) {
    EXPECT_NE(refusal(grid(bad)), "") << bad;
  }
  for (const std::string& bad :
       Texts{"infinity", "infinity ", "infinity fully", "infinity full ", "infinity 1", "full"}) {
    EXPECT_NE(refusal(with_line("infinity full", bad)), "") << bad;
  }
  EXPECT_EQ(refusal(with_line("infinity full", "infinity empty")), "");
}

TEST(Quoin, Vertices) {
  const auto vertex = [](const std::string& line) { return refusal(with_line("1 1 1 3", line)); };
  const std::string longest(max_coordinate_digits, '9');
  for (const std::string& good : Texts{longest + " -" + longest + " " + longest, "0 0 0 " + longest, "0 0 0 2"}) {
    EXPECT_EQ(vertex(good), "") << good;
  }
  for (const std::string& bad : Texts{"0 0 0 1", "0 0 0 0", "0 0 0 -2"}) {
    expect_refused(with_line("1 1 1 3", bad), 8, "at least 2");
  }
  for (const std::string& bad : Texts{"0 0",
                                      "0",
                                      "",
                                      "0 0 0 3 4",
                                      "0 0 0 3 ",
                                      "0 0 0 ",
                                      "0  0 0",
                                      "0\t0 0",
                                      " 0 0 0",
                                      "-0 0 0",
                                      "0 +1 0",
                                      "0 0 01",
                                      "0 0 -01",
                                      "- 0 0",
                                      "0 0 -",
                                      "0 0 --1",
                                      "0 0 1-",
                                      "1.5 0 0",
                                      "0 0 0 03",
                                      "1/2 0 0",
                                      "0,0,0",
                                      "1" + longest + " 0 0",
                                      "0 0 -1" + longest,
                                      "0 0 0 1" + longest,
                                      std::string("0 0 0\0", 6),
                                      "0 0 0\xff"}) {
    EXPECT_EQ(vertex(bad).rfind("line 8: ", 0), 0U) << bad << " " << vertex(bad);
  }
}

TEST(Quoin, Faces) {
  const auto plane = [](const std::string& line) { return refusal(with_line("0 0 1 0 1", line)); };
  const std::string longest(max_coefficient_digits, '9');
  EXPECT_EQ(plane(longest + " -" + longest + " " + longest + " " + longest + " 1"), "");
  for (const std::string& bad : Texts{"0 0 1 0", "0 0 1 0 0", "0 0 1 0 -1", "0 0 1 0 01", "0 0 1 0 1 1", "0 0 1 0 1 ",
                                      "0 0 1 -0 1", "", "0 0 1" + longest + " 0 1", "0 0 1 0 99999999999999999999999",
                                      "0 0 1 0 9", "0 0 1 0 4294967296", "0 0 1 0 x"}) {
    EXPECT_EQ(plane(bad).rfind("line 14: ", 0), 0U) << bad << " " << plane(bad);
  }
  // Fewer loops than declared.
  expect_refused(with_line("0 0 1 0 1", "0 0 1 0 2"), 16, "digits only");
  expect_refused(with_line("-1 0 0 -4611686018427387903 3", "-1 0 0 0 2"), 13, "expected");
  const auto loop = [](const std::string& line) { return refusal(with_line("2 1 0", line)); };
  for (const char* good : {"0", "3", "3 3", "0 1 2 3 0 1 2 3"}) EXPECT_EQ(loop(good), "") << good;
  for (const char* bad :
       {"4", "0 4", "0 99999999999999999999999", "-1", "+1", "01", "00", "", " 0", "0 ", "0  1", "0,1", "0.5", "x"}) {
    EXPECT_EQ(loop(bad).rfind("line 15: ", 0), 0U) << bad << " " << loop(bad);
  }
}

TEST(Quoin, CountsAreHeldAgainstTheText) {
  const std::string head = "quoin 1\ngrid 1 0 0 0\ninfinity empty\nvertices ";
  for (const char* absurd : {"4294967295", "4294967296", "99999999999999999999999999", "1000000"}) {
    expect_refused(head + absurd + "\n0 0 0\nfaces 0\nend\n", 4, "count");
    expect_refused(head + "0\nfaces " + absurd + "\nend\n", 5, "count");
    expect_refused(head + "1\n0 0 0\nfaces 1\n0 0 1 0 " + absurd + "\n0\nend\n", 7, "count");
  }
  expect_refused(head + "2\n0 0 0\nfaces 0\nend\n", 6, "integer");
  expect_refused(head + "0\n0 0 0\nfaces 0\nend\n", 5, "faces");
  expect_refused(head + "0\nfaces 0\n0 0 1 0 1\n0\nend\n", 6, "\"end\"");
  expect_refused(head + "0\nfaces 1\n0 0 1 0 1\n0\nend\n", 7, "index");
  for (const char* bad : {"-1", "00", "01", "+1", "1 1", "1 ", "", " 1", "1.0"}) {
    EXPECT_NE(refusal(head + bad + "\n0 0 0\nfaces 0\nend\n"), "") << bad;
    EXPECT_NE(refusal(head + "1\n0 0 0\nfaces " + bad + "\n0 0 1 0 1\n0\nend\n"), "") << bad;
  }
  // The smallest records that there are fill their bytes.
  EXPECT_EQ(refusal(head + "1\n0 0 0\nfaces 1\n0 0 1 0 1\n0\nend\n"), "");
}

TEST(Quoin, NothingStandsBehindTheEnd) {
  for (const char* garbage : {"\n", " ", "x", "end\n", "# comment\n", "\r\n", "quoin 1\n"}) {
    expect_refused(small + garbage, 16, "behind");
  }
  expect_refused(small + std::string(1, '\0'), 16, "behind");
  expect_refused(with_line("end", "end."), 16, "\"end\"");
}

TEST(Quoin, EveryPrefixIsRefused) {
  for (const std::string& text : Texts{small, test::with_crlf(small), "quoin 1\n# a\n" + small.substr(8)}) {
    EXPECT_EQ(refusal(text), "");
    for (std::size_t size = 0; size < text.size(); ++size) EXPECT_NE(refusal(text.substr(0, size)), "") << size;
  }
  expect_refused(small.substr(0, small.size() - 1), 16, "truncated");
  expect_refused(small.substr(0, small.size() - 4), 16, "truncated");
  expect_refused(small.substr(0, 30), 2, "truncated");
}

/// Changes, removes or doubles a few bytes, or swaps them for telling ones.
std::string mutant_of(std::string text, std::mt19937_64& random) {
  constexpr std::string_view telling = " \n\r\t-+./#0123456789endq\xff";
  for (std::uint64_t change = random() % 3 + 1; change > 0 && !text.empty(); --change) {
    const std::size_t at = random() % text.size();
    switch (random() % 5) {
      case 0:
        text[at] = static_cast<char>(random());
        break;
      case 1:
        text[at] = telling[random() % telling.size()];
        break;
      case 2:
        text.erase(at, random() % 8 + 1);
        break;
      case 3:
        text.insert(at, 1, telling[random() % telling.size()]);
        break;
      default:
        text.insert(at, text.substr(at, random() % 40));
    }
  }
  return text;
}

TEST(Quoin, MutantsAreRefusedOrReadForWhatTheySay) {
  std::mt19937_64 random(test::seed());
  std::size_t good = 0;
  const std::string texts[] = {small, test::with_crlf(small), write_quoin(random_document(random))};
  for (int round = 0; round < 30000; ++round) {
    const std::string mutant = mutant_of(texts[round % 3], random);
    if (refusal(mutant).empty()) ++good;
    ASSERT_FALSE(HasFailure()) << "round " << round << "\n" << mutant;
  }
  // Both ways are taken.
  EXPECT_GT(good, 1000U);
  EXPECT_LT(good, 20000U);
}

TEST(Quoin, LargeFiles) {
  ExactDocument document;
  const std::uint32_t count = 100000;
  for (std::uint32_t i = 0; i < count; ++i) document.vertices.push_back({std::to_string(i), "0", "-7", "1"});
  document.planes = {Record{"0", "0", "1", "7"}, Record{"0", "0", "-1", "-7"}};
  for (std::uint32_t i = 0; i < count; ++i) document.corners.push_back(i);
  document.loop_corners.push_back(count);
  document.face_loops.push_back(1);
  for (std::uint32_t i = 0; i < count; ++i) {
    document.corners.push_back(i);
    document.loop_corners.push_back(count + i + 1);
  }
  document.face_loops.push_back(count + 1);
  const std::string text = write_quoin(document);
  const Result<ExactDocument> read = read_quoin(text);
  ASSERT_TRUE(read) << read.error().where << read.error().message;
  EXPECT_TRUE(read.value() == document);
  EXPECT_EQ(refusal(text.substr(0, text.size() / 2)).rfind("line ", 0), 0U);
}

/// The files that docs/format.md shows.
std::vector<std::string> documented_files() {
  const std::filesystem::path root = std::filesystem::path(QUOIN_TEST_DATA).parent_path().parent_path();
  std::ifstream page(root / "docs" / "format.md");
  std::vector<std::string> files;
  std::string line;
  for (bool inside = false; std::getline(page, line);) {
    if (line.rfind("```", 0) == 0) {
      inside = line == "```quoin";
      if (inside) files.emplace_back();
    } else if (inside) {
      files.back() += line + "\n";
    }
  }
  return files;
}

/// Order, incidence and balance of a small solid, recomputed in machine integers.
void expect_small_canonical(const ExactDocument& document) {
  const auto numbers = [](const Record& record) {
    std::array<std::int64_t, 4> result{};
    for (std::size_t k = 0; k < 4; ++k) result[k] = std::stoll(record[k]);
    return result;
  };
  for (std::size_t i = 0; i + 1 < document.vertices.size(); ++i) {
    const auto p = numbers(document.vertices[i]), q = numbers(document.vertices[i + 1]);
    EXPECT_LT((std::array{p[0] * q[3], p[1] * q[3], p[2] * q[3]}), (std::array{q[0] * p[3], q[1] * p[3], q[2] * p[3]}));
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (std::size_t i = 0; i < document.planes.size(); ++i) {
    const auto plane = numbers(document.planes[i]);
    if (i > 0) {
      EXPECT_LE(numbers(document.planes[i - 1]), plane);
    }
    for (std::size_t j = document.face_loops[i]; j < document.face_loops[i + 1]; ++j) {
      const std::size_t first = document.loop_corners[j], last = document.loop_corners[j + 1];
      for (std::size_t k = first; k < last; ++k) {
        const std::uint32_t u = document.corners[k], v = document.corners[k + 1 == last ? first : k + 1];
        EXPECT_LE(document.corners[first], u);
        const auto point = numbers(document.vertices[u]);
        EXPECT_EQ(plane[0] * point[0] + plane[1] * point[1] + plane[2] * point[2] + plane[3] * point[3], 0);
        ++balance[{u, v}];
        --balance[{v, u}];
      }
    }
  }
  for (const auto& [edge, count] : balance) EXPECT_EQ(count, 0) << edge.first << " " << edge.second;
}

TEST(Quoin, DocumentedFilesAreRead) {
  const std::vector<std::string> files = documented_files();
  ASSERT_EQ(files.size(), 3U);
  for (const std::string& file : files) {
    EXPECT_EQ(refusal(file), "") << file;
    const Result<ExactDocument> read = read_quoin(file);
    ASSERT_TRUE(read);
    expect_small_canonical(read.value());
  }
}

}  // namespace
}  // namespace quoin::io
