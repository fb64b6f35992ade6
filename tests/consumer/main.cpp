// What a user of the installed package writes: only public headers, only the standard library beside them.
#include <quoin/quoin.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

// The cube [low, low + 2]^3.
quoin::Result<quoin::Solid> cube(double low, const quoin::Grid& grid) {
  std::vector<double> points;
  for (int corner = 0; corner < 8; ++corner) {
    for (int axis = 0; axis < 3; ++axis) points.push_back(low + 2.0 * ((corner >> axis) & 1));
  }
  const std::vector<std::uint32_t> triangles = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                                2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  return quoin::Solid::from_triangles(points, triangles, grid);
}

int fail(const std::string& what) {
  std::fprintf(stderr, "consumer: %s\n", what.c_str());
  return 1;
}

// A Boolean, a model and a motion before main begins, and again after it has ended.
class AtBothEnds {
 public:
  AtBothEnds() : first_(worked()) {}
  AtBothEnds(const AtBothEnds&) = delete;
  AtBothEnds& operator=(const AtBothEnds&) = delete;
  ~AtBothEnds() {
    if (worked() == first_) return;
    std::fputs("consumer: a static object found another result at the end than at the beginning\n", stderr);
    std::_Exit(1);
  }

 private:
  static std::string worked() {
    const quoin::Solid a = cube(0, {}).value(), b = cube(1, {}).value();
    const quoin::Motion turn = quoin::Motion::rotation({"0", "0", "1"}, "30").value();
    const quoin::Model model =
        quoin::Model::solid(a) + quoin::Model::cylinder("1", "5", "8").turned({"2", "1", "0", "0"});
    const quoin::Solid of_model = quoin::evaluate(model, {.grid = quoin::Grid::with_step("1/1000").value()}).value();
    return (a - b).to_quoin() + quoin::moved(b, turn).value().to_quoin() + of_model.to_quoin() +
           (quoin::statistics().symbolic > 0 ? "" : "nothing was counted");
  }

  std::string first_;
};

const AtBothEnds at_both_ends;

}  // namespace

int main() {
  std::printf("quoin %s, commit %s, compiler %s, format %d\n", QUOIN_VERSION_STRING, quoin::commit(), quoin::compiler(),
              quoin::format_version());
  const auto grid = quoin::Grid::with_step("1/2");
  if (!grid) return fail(grid.error().message);
  const auto a = cube(0, grid.value()), b = cube(1, grid.value());
  if (!a) return fail(a.error().message);
  if (!b) return fail(b.error().message);
  const std::string volume = (a.value() + b.value()).volume().value_or("unbounded");
  if (volume != "15") return fail("the union of two overlapping cubes has volume " + volume + " instead of 15");
  return 0;
}
