// What a Result and an Exception promise, in release builds too.
#include "quoin/result.h"

#include <gtest/gtest.h>

#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace quoin {
namespace {

const Error refusal{ErrorCode::open_boundary, "the surface is not closed", "a.stl", "face 3"};

/// What is thrown, as `what()` and as the error.
template <class Work>
Exception thrown(Work&& work) {
  try {
    work();
  } catch (const Exception& exception) {
    return exception;
  }
  return Exception({ErrorCode::usage, "nothing was thrown"});
}

TEST(Result, ValueOfAnErrorThrowsIt) {
  Result<std::string> result = refusal;
  const Result<std::string>& constant = result;
  const std::string says = "the surface is not closed (a.stl, face 3) [open-boundary]";
  EXPECT_EQ(thrown([&] { (void)result.value(); }).what(), says);
  EXPECT_EQ(thrown([&] { (void)constant.value(); }).what(), says);
  EXPECT_EQ(thrown([&] { (void)std::move(result).value(); }).what(), says);
  EXPECT_EQ(thrown([&] { (void)*result; }).what(), says);
  EXPECT_EQ(thrown([&] { (void)result->size(); }).what(), says);
  EXPECT_EQ(thrown([&] { (void)constant->size(); }).what(), says);
  const Result<void> action = refusal;
  EXPECT_EQ(thrown([&] { action.value(); }).what(), says);

  const Exception exception = thrown([&] { (void)result.value(); });
  EXPECT_EQ(exception.error().code, ErrorCode::open_boundary);
  EXPECT_EQ(exception.error().file, "a.stl");
  EXPECT_EQ(exception.error().where, "face 3");
  EXPECT_THROW((void)result.value(), std::runtime_error);
}

TEST(Result, ErrorOfAValueThrowsADefect) {
  const Result<int> result = 7;
  EXPECT_EQ(thrown([&] { (void)result.error(); }).error().code, ErrorCode::internal_defect);
  const Result<void> action;
  EXPECT_EQ(thrown([&] { (void)action.error(); }).error().code, ErrorCode::internal_defect);
}

TEST(Result, GivesItsValue) {
  Result<std::unique_ptr<int>> result = std::make_unique<int>(7);
  ASSERT_TRUE(result);
  EXPECT_EQ(**result, 7);
  EXPECT_EQ(*result.value(), 7);
  EXPECT_EQ(*result->get(), 7);
  const std::unique_ptr<int> taken = *std::move(result);
  EXPECT_EQ(*taken, 7);
  EXPECT_NO_THROW(Result<void>().value());
}

TEST(Exception, SaysWhatIsThere) {
  EXPECT_STREQ(Exception({ErrorCode::no_operand, "nothing"}).what(), "nothing [no-operand]");
  EXPECT_STREQ(Exception({ErrorCode::unreadable, "no", "f"}).what(), "no (f) [unreadable]");
  EXPECT_STREQ(Exception({ErrorCode::bad_index, "no", {}, "face 1"}).what(), "no (face 1) [bad-index]");
}

TEST(ErrorCode, IsPrintedAsItsText) {
  std::ostringstream out;
  out << ErrorCode::not_a_rotation;
  EXPECT_EQ(out.str(), "not-a-rotation");
  EXPECT_EQ(Error().code, ErrorCode::internal_defect);
}

}  // namespace
}  // namespace quoin
