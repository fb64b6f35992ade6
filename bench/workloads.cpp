/// Runs one generated workload and prints its stage times, memory, size and laws as one line of JSON.
/// Usage: quoin-workloads NAME [SIZE] [THREADS]; without arguments it lists the names.
#include <sys/resource.h>

#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "examples/models.h"
#include "quoin/quoin.h"

namespace {

using namespace quoin;
using examples::Random;

Options run_options;
Grid grid;

/// CPU seconds a stage, in the order in which they first come.
class Clock {
 public:
  void begin(const char* stage) {
    end();
    for (at_ = 0; at_ < stages_.size() && stages_[at_].first != stage;) ++at_;
    if (at_ == stages_.size()) stages_.emplace_back(stage, 0.0);
    start_ = std::clock();
  }
  void end() {
    if (at_ < stages_.size()) stages_[at_].second += double(std::clock() - start_) / CLOCKS_PER_SEC;
    at_ = SIZE_MAX;
  }
  const std::vector<std::pair<std::string, double>>& stages() const { return stages_; }
  double sum() const {
    double s = 0;
    for (const auto& [name, seconds] : stages_) s += seconds;
    return s;
  }

 private:
  std::vector<std::pair<std::string, double>> stages_;
  std::size_t at_ = SIZE_MAX;
  std::clock_t start_ = 0;
};
Clock importing, combining, exporting;

template <class Work>
auto timed(Clock& clock, const char* first, Work work) {
  clock.begin(first);
  auto result = work();
  clock.end();
  return result;
}

Options watched(Clock& clock) {
  Options options = run_options;
  options.stage = [&clock](const char* name) { clock.begin(name); };
  return options;
}

template <class T>
T must(Result<T> result) {
  if (result) return std::move(result).value();
  std::fprintf(stderr, "%s: %s\n", result.error().code.c_str(), result.error().message.c_str());
  std::exit(1);
}

Solid import(const Mesh& mesh) {
  ImportOptions options;
  options.grid = grid;
  options.run = watched(importing);
  return timed(importing, "prepare", [&] { return must(Solid::from_triangles(mesh.points, mesh.triangles, options)); });
}

std::vector<Solid> import(const std::vector<Mesh>& meshes) {
  std::vector<Solid> r;
  for (const Mesh& m : meshes) r.push_back(import(m));
  return r;
}

Solid boolean(const Expression& e) {
  return timed(combining, "prepare", [&] { return must(evaluate(e, watched(combining))); });
}

Expression all_of(const std::vector<Solid>& solids) { return Expression::union_of({solids.begin(), solids.end()}); }

using Rational = boost::multiprecision::mpq_rational;

/// Precondition: the solid is bounded.
Rational volume(const Solid& solid) { return Rational(solid.volume().value()); }
Rational volume(const Expression& e) { return volume(must(evaluate(e, run_options))); }

/// vol(A) + vol(B) = vol(A u B) + vol(A n B), vol(A) = vol(A - B) + vol(A n B), all exactly; `result` is A op B.
bool volumes_add_up(const Solid& result, char operation, const Expression& a, const Expression& b) {
  const Rational known = volume(result), common = operation == 'i' ? known : volume(a & b);
  if (operation == 'd') return volume(a) == known + common;
  return volume(a) + volume(b) == (operation == 'u' ? known : volume(a + b)) + common;
}

/// (A - B) u (A n B) = A.
bool splits_exactly(const Solid& a, const Solid& b) {
  const Solid difference = must(evaluate(Expression(a) - b, run_options)),
              common = must(evaluate(Expression(a) & b, run_options));
  return must(evaluate(Expression(difference) + common, run_options)) == a;
}

long peak_now() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

struct Outcome {
  Solid result;
  std::string law = "volumes add up";
  bool holds = true;
  long peak_kb = peak_now();  // before the laws are tried
};

Outcome two(const Mesh& first, const Mesh& second, char operation) {
  const Solid a = import(first), b = import(second);
  const Expression x(a), y(b);
  Outcome r{boolean(operation == 'u' ? x + y : operation == 'i' ? (x & y) : x - y)};
  r.law = "(A - B) u (A n B) = A, volumes add up";
  r.holds = splits_exactly(a, b) && volumes_add_up(r.result, operation, a, b);
  return r;
}

Mesh sphere(std::size_t triangles, double x) {
  return examples::geodesic_sphere({x, 0, 0}, 1,
                                   static_cast<std::uint32_t>(std::lround(std::sqrt(double(triangles) / 20))));
}

Outcome chain(std::size_t length) {
  Random random(7);
  Solid solid = import(examples::box({-1, -1, -1}, {1, 1, 1})), before = solid, tool = solid;
  char last = 'u';
  for (std::size_t i = 0; i < length; ++i) {
    const examples::Point c{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    tool = import(examples::icosphere(c, random.between(0.05, 0.3), 2));
    before = solid;
    last = random.unit() < 0.5 ? 'd' : 'u';
    solid = boolean(last == 'd' ? Expression(before) - tool : Expression(before) + tool);
  }
  Outcome r{solid};
  r.law = "volumes of the last operation add up";
  r.holds = volumes_add_up(solid, last, before, tool);
  return r;
}

Outcome cubes(std::size_t n) {
  Outcome r{boolean(all_of(import(examples::cube_grid(static_cast<std::uint32_t>(n), 1.0))))};
  r.law = "one box of 6 faces";
  r.holds = r.result.info().faces == 6;
  return r;
}

Outcome plate(std::size_t holes) {
  const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(double(holes))));
  const Solid plate = import(examples::box({0, 0, 0}, {double(side), double(side), 1}));
  const auto tools = import(examples::drills(side, side, 64));
  Outcome r{boolean(Expression(plate) - all_of(tools))};
  r.law = "64 walls a hole and 6 faces, volumes add up";
  r.holds = r.result.info().faces == 64ull * side * side + 6 && volumes_add_up(r.result, 'd', plate, all_of(tools));
  return r;
}

/// The union of many operands, against the unions of its halves.
Outcome union_of(const std::vector<Mesh>& meshes) {
  const std::vector<Solid> solids = import(meshes);
  Outcome r{boolean(all_of(solids))};
  const auto middle = solids.begin() + static_cast<std::ptrdiff_t>(solids.size() / 2);
  r.holds = volumes_add_up(r.result, 'u', all_of({solids.begin(), middle}), all_of({middle, solids.end()}));
  return r;
}

Outcome menger(std::size_t level) {
  const double size = std::pow(3.0, double(level));
  const Solid cube = import(examples::box({0, 0, 0}, {size, size, size}));
  Outcome r{boolean(Expression(cube) - all_of(import(examples::menger_holes(static_cast<unsigned>(level)))))};
  const std::string volume = std::to_string(std::llround(std::pow(20.0, double(level))));
  r.law = "volume " + volume;
  r.holds = r.result.volume() == volume;
  return r;
}

const std::map<std::string, std::pair<std::size_t, std::function<Outcome(std::size_t)>>>& workloads() {
  static const std::map<std::string, std::pair<std::size_t, std::function<Outcome(std::size_t)>>> all{
      {"spheres-union", {1000000, [](std::size_t n) { return two(sphere(n, 0), sphere(n, 0.5), 'u'); }}},
      {"spheres-intersection", {1000000, [](std::size_t n) { return two(sphere(n, 0), sphere(n, 0.5), 'i'); }}},
      {"spheres-difference", {1000000, [](std::size_t n) { return two(sphere(n, 0), sphere(n, 0.5), 'd'); }}},
      {"local-edit",
       {1000000,
        [](std::size_t n) {
          return two(sphere(n, 0), examples::geodesic_sphere({1, 0, 0}, 0.03, 7), 'd');
        }}},
      {"bumpy",
       {500000,
        [](std::size_t n) {
          return two(examples::bumpy_sphere({0, 0, 0}, 1, n, 1), examples::bumpy_sphere({0, 0, 0}, 1, n, 2), 'u');
        }}},
      {"cubes", {20, cubes}},
      {"plate", {10000, plate}},
      {"menger", {4, menger}},
      {"cloud", {1000, [](std::size_t n) { return union_of(examples::sphere_cloud(n, 1280, 3)); }}},
      {"needles",
       {150,
        [](std::size_t n) {
          return union_of(examples::needles(n, {0, 0, 0}, 1, 0.01, 3, 5));
        }}},
      {"chain", {1000, chain}},
  };
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || !workloads().contains(argv[1])) {
    for (const auto& [name, w] : workloads()) std::printf("%-22s default size %zu\n", name.c_str(), w.first);
    return argc < 2 ? 0 : 2;
  }
  const auto& [default_size, work] = workloads().at(argv[1]);
  const std::size_t size = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : default_size;
  run_options.threads = argc > 3 ? static_cast<unsigned>(std::strtoul(argv[3], nullptr, 10)) : 1;
  grid = must(Grid::with_step(std::string(argv[1]) == "plate" || std::string(argv[1]) == "menger" ||
                                      std::string(argv[1]) == "cubes"
                                  ? "1/65536"
                                  : "1/16777216"));
  const Outcome o = work(size);
  ExportReport report;
  const Mesh mesh =
      timed(exporting, "triangulate, round, check", [&] { return must(o.result.to_triangles({}, &report)); });
  std::printf("{\"workload\": \"%s\", \"size\": %zu, \"threads\": %u", argv[1], size, run_options.threads);
  const std::array<std::pair<const char*, const Clock*>, 3> clocks{
      {{"import", &importing}, {"boolean", &combining}, {"export", &exporting}}};
  for (const auto& [name, clock] : clocks) {
    std::printf(", \"%s\": %.3f, \"%s_stages\": {", name, clock->sum(), name);
    const char* comma = "";
    for (const auto& [stage, seconds] : clock->stages()) {
      std::printf("%s\"%s\": %.3f", comma, stage.c_str(), seconds);
      comma = ", ";
    }
    std::printf("}");
  }
  std::printf(
      ", \"peak_mb\": %ld, \"vertices\": %zu, \"triangles\": %zu, \"closed\": %s, \"flipped\": %llu, \"volume\": "
      "%.17g, \"law\": \"%s\", "
      "\"holds\": %s}\n",
      o.peak_kb / 1024, mesh.points.size() / 3, mesh.triangles.size() / 3, report.closed ? "true" : "false",
      static_cast<unsigned long long>(report.flipped), volume(o.result).convert_to<double>(), o.law.c_str(),
      o.holds ? "true" : "false");
  return report.closed && o.holds ? 0 : 1;
}
