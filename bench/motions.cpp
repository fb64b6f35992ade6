/// \file
/// What motions are for, at length: the measurements of docs/motions.md.
///
/// usage: quoin-motions blocks [N] | turn | baked | times
///   blocks  two blocks that share a face, and a row of ten, under N (10,000) random motions: no inner wall, ever
///   turn    the gear box turned by 1 degree 360 times: byte for byte what it was
///   baked   the same, the solid rounded at every step: drift and certificates
///   times   evaluation of the gear box at first, and after motions
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>

#include "examples/gear_box.h"
#include "examples/models.h"

namespace {

using namespace quoin;

double seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

Solid evaluated(const Model& model, MotionReport* report = nullptr) {
  auto solid = evaluate(model, {.run = {.threads = 1}}, report);
  if (!solid) {
    std::printf("%s: %s (%s)\n", to_string(solid.error().code).c_str(), solid.error().message.c_str(),
                solid.error().where.c_str());
    std::exit(1);
  }
  return std::move(solid).value();
}

Model block(const std::string& a, const std::string& b, const std::string& c) { return Model::block({a, b, c}); }

int blocks(int count) {
  examples::Random random(1);
  const auto number = [&](double limit) { return std::to_string(random.between(-limit, limit)); };
  std::vector<Model> row;
  for (int i = 0; i < 10; ++i) row.push_back(block("1/3", "1", "1/7").translated({std::to_string(i) + "/3", "0", "0"}));
  const std::pair<const char*, Model> models[] = {
      {"two blocks", block("1", "2", "3") + block("1", "2", "3").translated({"1", "0", "0"})},
      {"row of ten", Model::unite(row)}};
  for (const auto& [name, model] : models) {
    int whole = 0;
    double displacement = 0;
    const double begin = seconds();
    for (int i = 0; i < count; ++i) {
      const Model moved =
          model.rotated({number(9), number(9), number(9)}, number(180)).translated({number(5), number(5), number(5)});
      MotionReport report;
      const Info info = evaluated(moved, &report).info();
      whole += info.faces == 6 && info.vertices == 8 && info.edges == 12 && info.shells == 1;
      displacement = std::max(displacement, report.displacement);
    }
    std::printf(
        "%s: one block of 6 faces after %d of %d random motions; moved by rounding %.2g at most; %.2f ms each\n", name,
        whole, count, displacement, 1000 * (seconds() - begin) / count);
    if (whole != count) return 1;
  }
  return 0;
}

int turn() {
  MotionReport report;
  const std::string start = evaluated(examples::gear_box(), &report).to_quoin();
  Model turned = examples::gear_box();
  int same = 0;
  const Info first = evaluated(turned).info();
  for (int i = 1; i <= 360; ++i) {
    turned = turned.rotated({"0", "0", "1"}, "1");
    const Info info = evaluated(turned).info();
    same += info.faces == first.faces && info.vertices == first.vertices && info.edges == first.edges &&
            info.genus == first.genus && info.shells == first.shells;
  }
  const bool equal = evaluated(turned).to_quoin() == start;
  std::printf(
      "%llu primitives, %llu faces: the same faces, edges, vertices and holes at %d of 360 angles; after the full turn "
      "%s\n",
      static_cast<unsigned long long>(report.primitives), static_cast<unsigned long long>(first.faces), same,
      equal ? "byte for byte the start" : "ANOTHER SOLID");
  return equal ? 0 : 1;
}

int baked() {
  const Solid start = evaluated(examples::gear_box());
  const Motion step = Motion::rotation({"0", "0", "1"}, "1").value();
  Solid solid = start;
  double certified = 0;
  int by_planes = 0, steps = 0;
  for (; steps < 360; ++steps) {
    MotionReport report;
    auto next = moved(solid, step, {.run = {.threads = 1}}, &report);
    if (!next) {
      std::printf("step %d: %s: %s (%s)\n", steps + 1, to_string(next.error().code).c_str(),
                  next.error().message.c_str(), next.error().where.c_str());
      break;
    }
    certified += report.displacement;
    by_planes += report.by_planes == 1;
    solid = std::move(next).value();
  }
  // Measured at the corners of the box, which all faces make.
  const Info a = start.info(), b = solid.info();
  double drift = 0;
  for (std::size_t end = 0; end < 2; ++end)
    for (std::size_t k = 0; k < 3; ++k) drift = std::max(drift, std::fabs((*a.box)[end][k] - (*b.box)[end][k]));
  std::printf(
      "%d steps, %d plane by plane; certified drift %.3g, measured at the box %.3g; volume of the difference to the "
      "start %.3g\n",
      steps, by_planes, certified, drift, (start ^ solid).info().volume_approx);
  return 0;
}

int times() {
  const Model part = examples::gear_box();
  evaluated(part);  // warms up
  const auto timed = [](const char* name, const Model& model) {
    double best = HUGE_VAL;
    for (int i = 0; i < 5; ++i) {
      const double begin = seconds();
      evaluated(model);
      best = std::min(best, seconds() - begin);
    }
    std::printf("%s: %.1f ms\n", name, 1000 * best);
    std::fflush(stdout);
  };
  timed("at first", part);
  timed("translated by a third", part.translated({"1/3", "0", "0"}));
  timed("turned by 37 degrees about z", part.rotated({"0", "0", "1"}, "37"));
  timed("turned by 37 degrees about (1, 2, 3)", part.rotated({"1", "2", "3"}, "37"));
  Model many = part;
  for (int i = 0; i < 100; ++i) many = many.rotated({i % 2 ? "1" : "0", "0", "1"}, "0.01");
  timed("after 100 small turns about two axes", many);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const char* what = argc > 1 ? argv[1] : "";
  if (!std::strcmp(what, "blocks")) return blocks(argc > 2 ? std::atoi(argv[2]) : 10000);
  if (!std::strcmp(what, "turn")) return turn();
  if (!std::strcmp(what, "baked")) return baked();
  if (!std::strcmp(what, "times")) return times();
  std::fputs("usage: quoin-motions blocks [N] | turn | baked | times\n", stderr);
  return 2;
}
