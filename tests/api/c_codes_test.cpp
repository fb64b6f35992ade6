#include <gtest/gtest.h>

#include <set>
#include <string>

#include "c/guard.h"

namespace quoin::api_test {
namespace {

TEST(CCodes, AreThoseOfTheLibrary) {
  std::set<quoin_code> all{QUOIN_OK, QUOIN_BAD_ARGUMENT};
  for (int i = 0; i <= static_cast<int>(ErrorCode::internal_defect); ++i) {
    const auto code = static_cast<ErrorCode>(i);
    EXPECT_EQ(quoin_code_name(c::code_of(code)), to_string(code));
    EXPECT_TRUE(all.insert(c::code_of(code)).second);
  }
}

// What passes the guard is a code, whatever is thrown.
TEST(CCodes, NothingIsThrown) {
  quoin_error error;
  const auto code = [&](auto&& work) { return c::guarded(&error, work); };
  EXPECT_EQ(code([] {}), QUOIN_OK);
  EXPECT_EQ(code([] { throw std::bad_alloc(); }), QUOIN_OUT_OF_MEMORY);
  EXPECT_EQ(code([] { throw std::length_error("long"); }), QUOIN_OUT_OF_MEMORY);
  EXPECT_EQ(code([] { throw 7; }), QUOIN_INTERNAL_DEFECT);
  EXPECT_EQ(code([] { throw std::runtime_error("odd"); }), QUOIN_INTERNAL_DEFECT);
  EXPECT_STREQ(error.message, "odd");
  EXPECT_EQ(code([] { throw Exception({ErrorCode::bad_plane, "a", "b", "c"}); }), QUOIN_BAD_PLANE);
  EXPECT_EQ(std::string(error.message) + error.file + error.where, "abc");
  EXPECT_EQ(c::guarded(nullptr, [] { throw 7; }), QUOIN_INTERNAL_DEFECT);
}

TEST(CCodes, StructsBeginWithTheirSizeInCxxToo) {
  const quoin_info info = QUOIN_INIT(quoin_info);
  EXPECT_EQ(info.size, sizeof info);
  EXPECT_EQ(info.shells, 0u);
}

}  // namespace
}  // namespace quoin::api_test
