/// Runs one generated workload and prints its stage times, memory, size and laws as one line of JSON.
/// Usage: quoin-workloads NAME [SIZE] [THREADS]; without arguments it lists the names.
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <map>
#include <string>

#include "examples/models.h"
#include "quoin/quoin.h"

namespace {

using namespace quoin;
using examples::Random;

Options run_options;
Grid grid;
std::map<std::string, double> seconds;  // CPU seconds a stage

template <class Work>
auto timed(const char* stage, Work work) {
  const std::clock_t start = std::clock();
  auto result = work();
  seconds[stage] += double(std::clock() - start) / CLOCKS_PER_SEC;
  return result;
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
  options.run = run_options;
  return timed("import", [&] { return must(Solid::from_triangles(mesh.points, mesh.triangles, options)); });
}

std::vector<Solid> import(const std::vector<Mesh>& meshes) {
  std::vector<Solid> r;
  for (const Mesh& m : meshes) r.push_back(import(m));
  return r;
}

Solid boolean(const Expression& e) {
  return timed("boolean", [&] { return must(evaluate(e, run_options)); });
}

Expression all_of(const std::vector<Solid>& solids) { return Expression::union_of({solids.begin(), solids.end()}); }

/// vol(A) + vol(B) = vol(A u B) + vol(A n B), as rationals: symmetric difference of the halves is empty as well.
bool splits_exactly(const Solid& a, const Solid& b) {
  const Solid difference = must(evaluate(Expression(a) - b, run_options)), common = must(evaluate(Expression(a) & b, run_options));
  return must(evaluate(Expression(difference) + common, run_options)) == a;
}

struct Outcome {
  Solid result;
  std::string law = "none";
  bool holds = true;
};

Outcome two(const Mesh& first, const Mesh& second, char operation) {
  const Solid a = import(first), b = import(second);
  const Expression x(a), y(b);
  Outcome r{boolean(operation == 'u' ? x + y : operation == 'i' ? (x & y) : x - y)};
  r.law = "(A - B) u (A n B) = A";
  r.holds = splits_exactly(a, b);
  return r;
}

Mesh sphere(std::size_t triangles, double x) {
  return examples::geodesic_sphere({x, 0, 0}, 1, static_cast<std::uint32_t>(std::lround(std::sqrt(double(triangles) / 20))));
}

Outcome chain(std::size_t length) {
  Random random(7);
  Solid solid = import(examples::box({-1, -1, -1}, {1, 1, 1}));
  for (std::size_t i = 0; i < length; ++i) {
    const examples::Point c{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const Solid tool = import(examples::icosphere(c, random.between(0.05, 0.3), 2));
    solid = boolean(random.unit() < 0.5 ? Expression(solid) - tool : Expression(solid) + tool);
  }
  return {solid};
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
  r.law = "64 walls a hole and 6 faces";
  r.holds = r.result.info().faces == 64ull * side * side + 6;
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
      {"local-edit", {1000000, [](std::size_t n) { return two(sphere(n, 0), examples::geodesic_sphere({1, 0, 0}, 0.03, 7), 'd'); }}},
      {"bumpy", {500000, [](std::size_t n) {
         return two(examples::bumpy_sphere({0, 0, 0}, 1, n, 1), examples::bumpy_sphere({0, 0, 0}, 1, n, 2), 'u');
       }}},
      {"cubes", {20, cubes}},
      {"plate", {10000, plate}},
      {"menger", {4, menger}},
      {"cloud", {1000, [](std::size_t n) { return Outcome{boolean(all_of(import(examples::sphere_cloud(n, 1280, 3))))}; }}},
      {"needles", {150, [](std::size_t n) { return Outcome{boolean(all_of(import(examples::needles(n, {0, 0, 0}, 1, 0.01, 3, 5))))}; }}},
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
  grid = must(Grid::with_step(std::string(argv[1]) == "plate" || std::string(argv[1]) == "menger" || std::string(argv[1]) == "cubes"
                                  ? "1/65536"
                                  : "1/16777216"));
  const Outcome o = work(size);
  ExportReport report;
  const Mesh mesh = timed("export", [&] { return must(o.result.to_triangles({}, &report)); });
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("{\"workload\": \"%s\", \"size\": %zu, \"threads\": %u, \"import\": %.3f, \"boolean\": %.3f, \"export\": %.3f, ", argv[1], size,
              run_options.threads, seconds["import"], seconds["boolean"], seconds["export"]);
  std::printf("\"peak_mb\": %ld, \"vertices\": %zu, \"triangles\": %zu, \"closed\": %s, \"flipped\": %llu, \"law\": \"%s\", \"holds\": %s}\n",
              usage.ru_maxrss / 1024, mesh.points.size() / 3, mesh.triangles.size() / 3, report.closed ? "true" : "false",
              static_cast<unsigned long long>(report.flipped), o.law.c_str(), o.holds ? "true" : "false");
  return report.closed && o.holds ? 0 : 1;
}
