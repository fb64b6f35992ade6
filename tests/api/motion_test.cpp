// What a motion is made of, and what is refused.
#include <gtest/gtest.h>

#include "quoin/quoin.h"

namespace quoin {
namespace {

/// "code, where" of an error; "" without one.
std::string refusal(const Result<Motion>& motion) {
  return motion ? "" : to_string(motion.error().code) + ", " + motion.error().where;
}

TEST(Motion, ErrorsNameTheNumber) {
  EXPECT_EQ(refusal(Motion::rotation({"0", "0", "1"}, "30")), "");
  EXPECT_EQ(refusal(Motion::rotation({"0", "", "1"}, "30")), "bad-number, axis, y");
  EXPECT_EQ(refusal(Motion::rotation({"0", "0", "1"}, "30 degrees")), "bad-number, angle");
  EXPECT_EQ(refusal(Motion::translation({"far", "0", "1"})), "bad-number, translation, x");
  EXPECT_EQ(refusal(Motion::quaternion({"0", "1", "2", "3/0"})), "bad-number, quaternion, z");
  EXPECT_EQ(refusal(Motion::quaternion({"w", "1", "2", "3"})), "bad-number, quaternion, w");
  EXPECT_EQ(refusal(Motion::mirror({"1", "0", "up"})), "bad-number, normal, z");
  EXPECT_EQ(refusal(Motion::scaling({"1", "--1", "1"})), "bad-number, factors, y");
  EXPECT_EQ(refusal(Motion::matrix({Text3{"1", "0", "0"}, {"0", "1", "0"}, {"one", "0", "1"}})),
            "bad-number, row 2, x");
}

}  // namespace
}  // namespace quoin
