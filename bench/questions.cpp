/// Times questions to one solid and prints a row each: a union of two spheres, or of many small ones.
/// Usage: quoin-questions [TRIANGLES [THREADS]], one million and one thread when not told.
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "bench/combine.h"
#include "bench/workloads.h"
#include "quoin/quoin.h"

namespace {

using namespace quoin;
using bench::must;

std::mt19937_64 random_numbers(1);  // NOLINT: the same numbers every time

/// A multiple of 2^-20 in -1.5 .. 1.5.
double coordinate() { return static_cast<double>(random_numbers() % (3u << 20)) * 0x1p-20 - 1.5; }
std::array<double, 3> point() { return {coordinate(), coordinate(), coordinate()}; }

/// Seconds of work().
template <class Work>
double seconds(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void row(const char* question, double count, double time) {
  std::printf("| %s | %.2f |\n", question, time / count * 1e6);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t size = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000000;
  Options run;
  run.threads = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1;
  const bench::Workload& w = *bench::find_workload("spheres-union");
  ImportOptions import;
  import.grid = must(Grid::with_step(w.step));
  import.trust = Trust::embedded;
  std::vector<Solid> spheres;
  for (const Mesh& m : w.operands(size)) spheres.push_back(must(Solid::from_triangles(m.points, m.triangles, import)));
  const Solid solid = must(unite(spheres, run));

  std::optional<Questions> made;
  const double making = seconds([&] { made.emplace(solid); });
  const Questions& questions = *made;
  std::printf("faces %llu, index in %.2f s\n| question | microseconds |\n|---|---|\n",
              static_cast<unsigned long long>(solid.counts().faces), making);

  constexpr std::size_t many = 200000, few = 20000;
  std::vector<double> points;
  for (std::size_t i = 0; i < 3 * many; ++i) points.push_back(coordinate());
  std::size_t sink = 0;
  row("`classify`, many points", many, seconds([&] { sink += must(questions.classify(points, run)).size(); }));
  row("`ray`, along an axis", few, seconds([&] {
        for (std::size_t i = 0; i < few; ++i) sink += must(questions.ray(point(), {0, 0, 1})).contacts.size();
      }));
  row("`ray`, any direction", few, seconds([&] {
        for (std::size_t i = 0; i < few; ++i) sink += must(questions.ray(point(), point())).contacts.size();
      }));
  row("`segment`", few, seconds([&] {
        for (std::size_t i = 0; i < few; ++i) sink += must(questions.segment(point(), point())).contacts.size();
      }));
  row("`nearest`", 2000, seconds([&] {
        for (int i = 0; i < 2000; ++i) sink += questions.nearest(point())->faces.size();
      }));
  const Questions first(spheres[0]), second(spheres[1]);
  row("`interference` of the two", 1,
      seconds([&] { sink += must(interference(first, second)) == Interference::overlapping; }));
  row("`section`", 20, seconds([&] {
        for (int i = 0; i < 20; ++i)
          sink += must(questions.section({{"1", "2", "3", std::to_string(i) + "/17"}})).vertices.size();
      }));
  row("`area_bounds`", 1, seconds([&] { sink += questions.area_bounds()[1] > 0; }));
  row("`mass_properties`", 1, seconds([&] { sink += questions.mass_properties()->volume.exact.size(); }));
  return sink == 0;
}
