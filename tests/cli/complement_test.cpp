#include "tests/cli/support.h"

namespace quoin::cli_test {
namespace {

TEST_F(CliTest, ComplementIsUnboundedAndAnInvolution) {
  const Outcome r = run({"complement", "a.off", "-o", "out.quoin", "--json"});
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.json()["volume"], nullptr);
  EXPECT_EQ(r.json()["bounded"], false);
  ASSERT_EQ(run({"complement", "out.quoin", "-o", "back.quoin"}).code, 0);
  ASSERT_EQ(run({"convert", "a.off", "-o", "same.quoin"}).code, 0);
  EXPECT_EQ(get("back.quoin"), get("same.quoin"));
}

TEST_F(CliTest, TriangleFormatsRefuseTheUnbounded) {
  expect_error(run({"complement", "a.off", "-o", "out.stl", "--json"}), 1, "unbounded", "out.stl");
  EXPECT_EQ(names(), (std::set<std::string>{"a.off", "b.off"}));
}

}  // namespace
}  // namespace quoin::cli_test
