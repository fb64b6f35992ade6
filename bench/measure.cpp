/// Runs one generated workload and prints its stage times, memory, size and laws as one line of JSON, or writes its
/// operands into a folder for the programs of bench/compare.
/// Usage: quoin-workloads NAME [SIZE [THREADS]] | quoin-workloads write NAME SIZE FOLDER; without arguments it lists
/// the names.
#include <sys/resource.h>

#include <array>
#include <atomic>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bench/combine.h"
#include "bench/workloads.h"
#include "exact/counters.h"
#include "examples/mesh_file.h"
#include "quoin/quoin.h"

namespace {

using namespace quoin;
using bench::must;
using bench::Operation;
using bench::Workload;

Options run_options;
Grid grid;

std::atomic<std::uint64_t> allocations = 0;

/// CPU seconds and allocations a stage, in the order in which they first come.
class Clock {
 public:
  struct Stage {
    std::string name;
    double seconds = 0;
    std::uint64_t allocations = 0;
  };

  void begin(const char* stage) {
    end();
    for (at_ = 0; at_ < stages_.size() && stages_[at_].name != stage;) ++at_;
    if (at_ == stages_.size()) stages_.push_back({stage});
    start_ = std::clock();
    allocated_ = allocations;
  }
  void end() {
    if (at_ < stages_.size()) {
      stages_[at_].seconds += double(std::clock() - start_) / CLOCKS_PER_SEC;
      stages_[at_].allocations += allocations - allocated_;
    }
    at_ = SIZE_MAX;
  }
  const std::vector<Stage>& stages() const { return stages_; }
  Stage sum() const {
    Stage all;
    for (const Stage& s : stages_) all.seconds += s.seconds, all.allocations += s.allocations;
    return all;
  }

 private:
  std::vector<Stage> stages_;
  std::size_t at_ = SIZE_MAX;
  std::clock_t start_ = 0;
  std::uint64_t allocated_ = 0;
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

Expression all_of(const std::vector<Solid>& solids) { return Expression::unite({solids.begin(), solids.end()}); }

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

/// The law that a workload's result is held against, and whether it holds.
struct Law {
  std::string text = "volumes add up";
  bool holds = true;
};

Law law_of_two(const Workload& w, const std::vector<Solid>& s, const Solid& result) {
  const char operation = w.operation == Operation::unite ? 'u' : w.operation == Operation::intersect ? 'i' : 'd';
  return {"(A - B) u (A n B) = A, volumes add up",
          splits_exactly(s[0], s[1]) && volumes_add_up(result, operation, s[0], s[1])};
}

Law law(const Workload& w, std::size_t size, const std::vector<Solid>& s, const Solid& before, const Solid& result) {
  if (w.name.starts_with("cubes")) return {"one box of 6 faces", result.info().faces == 6};
  if (w.name == "menger") {
    const std::string volume = std::to_string(std::llround(std::pow(20.0, double(size))));
    return {"volume " + volume, result.volume() == volume};
  }
  if (w.operation == Operation::subtract_each)
    return {"volumes of the last operation add up", volumes_add_up(result, 'd', before, s.back())};
  if (w.operation == Operation::unite_differences) {
    Rational sum = 0;
    for (std::size_t i = 0; i < s.size(); i += 2) sum += volume(Expression(s[i]) - s[i + 1]);
    return {"the sum of the parts", volume(result) == sum};
  }
  if (w.operation == Operation::subtract_nested) {
    Rational sum = 0;
    for (std::size_t i = s.size(); i-- > 0;) sum = volume(s[i]) - sum;
    return {"volumes of shells add up", volume(result) == sum};
  }
  if (w.operation == Operation::unite_leaning)
    return {"the union of all", result == must(evaluate(all_of(s), run_options))};
  if (w.operation == Operation::alternate) {  // an operand overlaps its neighbours only
    std::vector<Expression> parts{s[0]};
    for (std::size_t i = 1; i < s.size(); i += 2)
      parts.push_back(i + 1 < s.size() ? Expression(s[i]) - s[i + 1] : Expression(s[i]));
    return {"each second one without the one after it",
            result == must(evaluate(Expression::unite(parts), run_options))};
  }
  if (w.operation == Operation::unite_remainders) {
    const Expression common = Expression::intersect({s.begin() + 1, s.end()});
    return {"the first without what all others have in common", result == must(evaluate(s[0] - common, run_options))};
  }
  if (s.size() == 2) return law_of_two(w, s, result);
  const auto middle = s.begin() + static_cast<std::ptrdiff_t>(s.size() / 2);
  if (w.operation == Operation::unite)
    return {"volumes add up", volumes_add_up(result, 'u', all_of({s.begin(), middle}), all_of({middle, s.end()}))};
  const std::size_t walls = w.name == "drill" ? 24 : 64;
  return {std::to_string(walls) + " walls a hole and 6 faces, volumes add up",
          result.info().faces == walls * (s.size() - 1) + 6 &&
              volumes_add_up(result, 'd', s[0], all_of({s.begin() + 1, s.end()}))};
}

/// Of a result that comes of no operands.
Law law_of_made(const Workload& w, std::size_t n, const Solid& result) {
  const Info info = result.info();
  if (w.name == "half-spaces")
    return {"a face a plane, 2 n - 4 vertices", info.faces == n && info.vertices == 2 * n - 4};
  if (w.name == "mesh-duplicates") return {"one tetrahedron", info.faces == 4 && info.vertices == 4};
  if (w.name == "mesh-needles" || w.name == "mesh-bars") return {"one shell", info.shells == 1};
  if (w.name == "swept-star") return {"a face a side, 2 n vertices", info.faces == n + 2 && info.vertices == 2 * n};
  // The last term is a difference if there are as many of each.
  if (w.name == "in-turn") return {"a box, or one with a notch", info.faces == (n % 2 == 0 ? 9u : 6u)};
  return {"all points are vertices", info.vertices == n};
}

int write(const Workload& w, std::size_t size, const std::string& folder) {
  if (w.operands == nullptr) {
    std::fprintf(stderr, "%s has no operands\n", w.name.c_str());
    return 2;
  }
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/operation") << bench::name(w.operation) << "\n";
  std::ofstream(folder + "/step") << w.step << "\n";
  std::size_t i = 0;
  for (const Mesh& mesh : w.operands(size))
    if (auto written = examples::write_mesh_file(folder + "/" + std::to_string(i++) + ".off", mesh); !written) {
      std::fprintf(stderr, "%s\n", written.error().message.c_str());
      return 1;
    }
  return 0;
}

unsigned long long count(std::uint64_t n) { return n; }

int run(const Workload& w, std::size_t size) {
  grid = must(Grid::with_step(w.step));
  std::vector<Solid> solids;
  Solid before, result;  // of the last operation
  if (w.made != nullptr) {
    result = timed(combining, "prepare", [&] { return w.made(size, grid, watched(combining)); });
  } else {
    solids = import(w.operands(size));
    result = solids[0];
    bench::combine(bench::name(w.operation), solids, [&](const Expression& e) {
      before = result;
      return result = boolean(e);
    });
  }
  const long peak_mb = peak_now() / 1024;  // before the law is tried
  ExportReport report;
  const Mesh mesh =
      timed(exporting, "prepare", [&] { return must(result.to_triangles({.run = watched(exporting)}, &report)); });
  const exact::Counters rungs = exact::total_counters();  // before the law is tried
  const Law tried = w.made != nullptr ? law_of_made(w, size, result) : law(w, size, solids, before, result);
  std::printf("{\"workload\": \"%s\", \"size\": %zu, \"threads\": %u", w.name.c_str(), size, run_options.threads);
  const std::array<std::pair<const char*, const Clock*>, 3> clocks{
      {{"import", &importing}, {"boolean", &combining}, {"export", &exporting}}};
  for (const auto& [name, clock] : clocks) {
    std::printf(", \"%s\": %.3f, \"%s_allocations\": %llu, \"%s_stages\": {", name, clock->sum().seconds, name,
                count(clock->sum().allocations), name);
    const char* comma = "";
    for (const Clock::Stage& s : clock->stages()) {
      std::printf("%s\"%s\": %.3f", comma, s.name.c_str(), s.seconds);
      comma = ", ";
    }
    std::printf("}");
  }
  std::printf(
      ", \"symbolic\": %llu, \"filter\": %llu, \"fixed_width\": %llu, \"rational\": %llu"
      ", \"peak_mb\": %ld, \"vertices\": %zu, \"triangles\": %zu, \"closed\": %s, \"flipped\": %llu, \"volume\": "
      "%.17g, \"law\": \"%s\", "
      "\"holds\": %s}\n",
      count(rungs.symbolic), count(rungs.filter), count(rungs.fixed_width), count(rungs.rational), peak_mb,
      mesh.points.size() / 3, mesh.triangles.size() / 3, report.closed ? "true" : "false", count(report.flipped),
      volume(result).convert_to<double>(), tried.text.c_str(), tried.holds ? "true" : "false");
  return report.closed && tried.holds ? 0 : 1;
}

}  // namespace

void* operator new(std::size_t size) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  if (void* const p = std::malloc(size)) return p;
  std::abort();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

int main(int argc, char** argv) {
  const bool writes = argc == 5 && std::string(argv[1]) == "write";
  const Workload* workload = argc < 2 ? nullptr : bench::find_workload(argv[writes ? 2 : 1]);
  if (workload == nullptr) {
    for (const Workload& w : bench::workloads())
      std::printf("%-22s %-14s %zu %s\n", w.name.c_str(), w.made != nullptr ? "made" : bench::name(w.operation),
                  w.default_size, w.unit.c_str());
    return argc < 2 ? 0 : 2;
  }
  const auto number = [&](int i, std::size_t otherwise) {
    return argc > i ? std::size_t{std::strtoull(argv[i], nullptr, 10)} : otherwise;
  };
  if (writes) return write(*workload, number(3, 0), argv[4]);
  run_options.threads = static_cast<unsigned>(number(3, 1));
  return run(*workload, number(2, workload->default_size));
}
