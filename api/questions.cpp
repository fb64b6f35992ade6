#include "quoin/questions.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "api/access.h"
#include "api/run.h"
#include "booleans/questions/along_line.h"
#include "booleans/questions/interference.h"
#include "booleans/questions/moments.h"
#include "booleans/questions/nearest.h"
#include "booleans/questions/section.h"
#include "grid/lists/stretches.h"

namespace quoin {

using exact::Rational;

struct Questions::Data {
  Solid solid;
  booleans::ModelFrame frame;
  booleans::Index index;

  Data(const Solid& s, Faces faces)
      : solid(s), frame(Access::lattice(solid)), index(Access::body(solid), faces == Faces::by_label) {}
};

Questions::Questions(const Solid& solid, Faces faces) : data_(std::make_shared<const Data>(solid, faces)) {}
Questions::~Questions() = default;
Questions::Questions(const Questions&) = default;
Questions::Questions(Questions&&) noexcept = default;
Questions& Questions::operator=(const Questions&) = default;
Questions& Questions::operator=(Questions&&) noexcept = default;

const Solid& Questions::solid() const { return data_->solid; }

namespace {

using ModelPoint = std::array<Rational, 3>;

Location location(int side) { return side > 0 ? Location::inside : side < 0 ? Location::outside : Location::boundary; }

ExactNumber exact_number(const Rational& v) { return {exact::to_string(v), exact::to_double(v)}; }

bool are_finite(const std::array<double, 3>& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

/// Exactly these numbers; `name` says in an error whose they are.
Result<ModelPoint> model_point(const std::array<double, 3>& p, const char* name) {
  if (!are_finite(p)) return Error{ErrorCode::non_finite, "a coordinate is infinite or not a number", {}, name};
  return ModelPoint{exact::to_rational(p[0]), exact::to_rational(p[1]), exact::to_rational(p[2])};
}
Result<ModelPoint> model_point(const Questions::Numbers& p, const char* name) {
  ModelPoint r;
  for (std::size_t k = 0; k < 3; ++k) {
    auto v = exact::parse_rational(p[k]);
    if (!v)
      return Error{ErrorCode::bad_number,
                   "\"" + p[k].substr(0, 80) + "\" is neither a decimal nor a rational p/q",
                   {},
                   std::string(name) + ", " + "xyz"[k]};
    r[k] = *std::move(v);
  }
  return r;
}

bool is_zero_vector(const ModelPoint& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

Passage passage_of(const booleans::Index& index, const booleans::ModelFrame& frame, const ModelPoint& from,
                   const ModelPoint& direction, const std::optional<Rational>& last) {
  const booleans::Line line(booleans::QueryPoint(frame.point(from)), frame.direction(direction));
  booleans::Passage found = booleans::passage(index, line, last);

  Passage r{location(found.start), {}};
  r.contacts.reserve(found.contacts.size());
  for (booleans::Contact& c : found.contacts)
    r.contacts.push_back(
        {exact_number(c.begin), exact_number(c.end), location(c.before), location(c.behind), std::move(c.faces)});
  return r;
}

template <class Vector>
Result<Passage> ray_of(const booleans::Index& index, const booleans::ModelFrame& frame, const Vector& from,
                       const Vector& direction) {
  const auto p = model_point(from, "from"), d = model_point(direction, "direction");
  if (!p) return p.error();
  if (!d) return d.error();
  if (is_zero_vector(*d)) return Error{ErrorCode::bad_axis, "the direction of a ray is 0", {}, "direction"};
  return passage_of(index, frame, *p, *d, std::nullopt);
}

template <class Vector>
Result<Passage> segment_of(const booleans::Index& index, const booleans::ModelFrame& frame, const Vector& from,
                           const Vector& to) {
  const auto p = model_point(from, "from"), q = model_point(to, "to");
  if (!p) return p.error();
  if (!q) return q.error();
  ModelPoint d;
  for (std::size_t k = 0; k < 3; ++k) d[k] = (*q)[k] - (*p)[k];
  if (is_zero_vector(d)) return Error{ErrorCode::bad_axis, "the ends of a segment are equal", {}, "to"};
  return passage_of(index, frame, *p, d, Rational(1));
}

}  // namespace

Location Questions::classify(const std::array<double, 3>& point) const {
  assert(are_finite(point));
  return location(booleans::locate(data_->index, booleans::QueryPoint(data_->frame, point)));
}

Result<std::vector<Location>> Questions::classify(Coordinates points, const Options& run) const {
  return std::visit(
      [&](const auto& values) -> Result<std::vector<Location>> {
        assert(values.size() % 3 == 0);
        const auto bad = std::find_if_not(values.begin(), values.end(), [](auto x) { return std::isfinite(x); });
        if (bad != values.end())
          return Error{ErrorCode::non_finite,
                       "a coordinate is infinite or not a number",
                       {},
                       "point " + std::to_string((bad - values.begin()) / 3)};

        const std::size_t count = values.size() / 3;
        std::vector<Location> r(count);
        const auto is_cancelled = [&] { return run.cancel != nullptr && run.cancel->load(std::memory_order_relaxed); };
        with_threads(run.threads, [&] {
          grid::in_stretches(
              count, grid::stretch(std::size_t{1} << 10), [&](std::size_t, std::size_t begin, std::size_t end) {
                if (is_cancelled()) return;
                for (std::size_t i = begin; i < end; ++i)
                  r[i] = classify({double(values[3 * i]), double(values[3 * i + 1]), double(values[3 * i + 2])});
              });
          return 0;
        });
        if (is_cancelled()) return Error{ErrorCode::cancelled, "the operation was cancelled", {}, {}};
        if (run.progress) run.progress(1);
        return r;
      },
      points.values());
}

Result<Passage> Questions::ray(const std::array<double, 3>& from, const std::array<double, 3>& direction) const {
  return ray_of(data_->index, data_->frame, from, direction);
}
Result<Passage> Questions::ray(const Numbers& from, const Numbers& direction) const {
  return ray_of(data_->index, data_->frame, from, direction);
}
Result<Passage> Questions::segment(const std::array<double, 3>& from, const std::array<double, 3>& to) const {
  return segment_of(data_->index, data_->frame, from, to);
}
Result<Passage> Questions::segment(const Numbers& from, const Numbers& to) const {
  return segment_of(data_->index, data_->frame, from, to);
}

namespace {

std::array<ExactNumber, 3> in_model_units(const booleans::RationalPoint& p, const grid::Lattice& lattice) {
  std::array<ExactNumber, 3> r;
  for (std::size_t k = 0; k < 3; ++k) r[k] = exact_number(lattice.origin[k] + lattice.step * p[k]);
  return r;
}

}  // namespace

std::optional<Nearest> Questions::nearest(const std::array<double, 3>& point) const {
  assert(are_finite(point));
  const booleans::QueryPoint from(data_->frame, point);
  auto found = booleans::nearest(data_->index, from);
  if (!found) return std::nullopt;

  const grid::Lattice& lattice = data_->frame.lattice();
  const int side = found->squared_distance == 0 ? 0 : booleans::locate(data_->index, from);
  return Nearest{exact_number(found->squared_distance * lattice.step * lattice.step),
                 in_model_units(found->point, lattice), std::move(found->faces), location(side)};
}

namespace {

/// From grid steps to model units: x = o + s X.
booleans::Moments in_model_units(const booleans::Moments& m, const grid::Lattice& lattice) {
  const Rational &s = lattice.step, cubic = s * s * s;
  const auto& o = lattice.origin;
  booleans::Moments r{m.volume * cubic, {}, {}};
  for (std::size_t k = 0; k < 3; ++k) r.first[k] = cubic * (o[k] * m.volume + s * m.first[k]);
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [i, j] = booleans::axes_of_moment(k);
    r.second[k] = cubic * (o[i] * o[j] * m.volume + s * (o[i] * m.first[j] + o[j] * m.first[i]) + s * s * m.second[k]);
  }
  return r;
}

template <std::size_t N>
std::array<ExactNumber, N> exact_numbers(const std::array<Rational, N>& v) {
  std::array<ExactNumber, N> r;
  std::transform(v.begin(), v.end(), r.begin(), exact_number);
  return r;
}

/// Steiner: the second moments about the centroid, then their sums.
std::array<Rational, 6> inertia_of(const booleans::Moments& m) {
  std::array<Rational, 6> central, r;
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [i, j] = booleans::axes_of_moment(k);
    central[k] = m.second[k] - m.first[i] * m.first[j] / m.volume;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    r[k] = central[(k + 1) % 3] + central[(k + 2) % 3];
    r[3 + k] = -central[3 + k];
  }
  return r;
}

}  // namespace

std::optional<MassProperties> Questions::mass_properties() const {
  if (!data_->solid.is_bounded()) return std::nullopt;
  const booleans::Moments m = in_model_units(booleans::moments(data_->index), data_->frame.lattice());
  MassProperties r{exact_number(m.volume), exact_numbers(m.first), exact_numbers(m.second), {}, {}};
  if (m.volume == 0) return r;
  r.centroid = exact_numbers(
      ModelPoint{Rational(m.first[0] / m.volume), Rational(m.first[1] / m.volume), Rational(m.first[2] / m.volume)});
  r.inertia = exact_numbers(inertia_of(m));
  return r;
}

std::array<double, 2> Questions::area_bounds() const {
  const booleans::Interval step = booleans::enclosure(data_->frame.lattice().step);
  const booleans::Interval area = booleans::area(data_->index) * (step * step);
  return {std::max(area.low, 0.0), area.high};
}

namespace {

/// In grid steps.
Result<booleans::IntegerPlane> integer_plane(const HalfSpace& half_space, const grid::Lattice& lattice) {
  std::array<Rational, 4> p;
  for (std::size_t k = 0; k < 4; ++k) {
    auto v = exact::parse_rational(half_space.plane[k]);
    if (!v)
      return Error{ErrorCode::bad_plane, "the coefficient \"" + half_space.plane[k].substr(0, 80) +
                                             "\" of a plane is neither a decimal nor a rational p/q"};
    p[k] = *std::move(v);
  }
  if (p[0] == 0 && p[1] == 0 && p[2] == 0) return Error{ErrorCode::bad_plane, "a plane has no normal"};
  for (std::size_t k = 0; k < 3; ++k) {
    p[3] += p[k] * lattice.origin[k];
    p[k] *= lattice.step;
  }
  return exact::primitive(p);
}

/// |n| / |n_k| of the projected area, square grid steps.
void add_area(const booleans::Section& section, const booleans::IntegerPlane& plane, const Rational& step, Section& r) {
  const std::array<exact::Integer, 3> n{plane[0], plane[1], plane[2]};
  const exact::Integer square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2], longest = n[exact::longest_component(n)];
  const Rational projected = section.projected_area * step * step;

  if (square == longest * longest) r.area = exact_number(projected);
  // A number is longer than its square root only below 1, where 0 is not far.
  const booleans::Interval squared =
      booleans::enclosure(Rational(projected * projected * Rational(square, longest * longest)));
  r.area_bounds = {std::max(0.0, std::nextafter(std::sqrt(std::max(squared.low, 0.0)), -HUGE_VAL)),
                   std::nextafter(std::sqrt(squared.high), HUGE_VAL)};
}

}  // namespace

Result<Section> Questions::section(const HalfSpace& half_space) const {
  const grid::Lattice& lattice = data_->frame.lattice();
  const auto plane = integer_plane(half_space, lattice);
  if (!plane) return plane.error();
  if (!data_->solid.is_bounded())
    return Error{ErrorCode::unbounded, "the section of an unbounded solid may be unbounded"};
  const auto found = booleans::section(data_->index, *plane);
  if (!found) return Error{ErrorCode::inconsistent, "the solid was trusted to be one, and is none"};

  Section r{};
  r.vertices.reserve(found->vertices.size());
  for (const auto& p : found->vertices) r.vertices.push_back(in_model_units(p, lattice));
  for (std::size_t f = 0; f + 1 < found->polygons.face_start.size(); ++f) {
    auto& polygon = r.polygons.emplace_back();
    found->polygons.for_loops(
        f, [&](std::span<const std::uint32_t> loop) { polygon.emplace_back(loop.begin(), loop.end()); });
  }
  add_area(*found, *plane, lattice.step, r);
  return r;
}

Result<Interference> interference(const Questions& a, const Questions& b, const Options& run) {
  if (!(a.solid().grid() == b.solid().grid())) {
    const auto b_on_a = b.solid().on_grid(a.solid().grid());
    if (b_on_a) return interference(a, Questions(*b_on_a), run);
    const auto a_on_b = a.solid().on_grid(b.solid().grid());
    return a_on_b ? interference(Questions(*a_on_b), b, run) : b_on_a.error();
  }

  switch (booleans::meeting(a.data_->index, b.data_->index)) {
    case booleans::Meeting::apart:
      return Interference::apart;
    case booleans::Meeting::overlapping:
      return Interference::overlapping;
    case booleans::Meeting::contact:
      break;
  }
  const auto common = intersect({a.solid(), b.solid()}, run);
  if (!common) return common.error();
  return common->is_empty() ? Interference::touching : Interference::overlapping;
}

}  // namespace quoin
