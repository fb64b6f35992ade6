#include "quoin/boundary.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "api/access.h"
#include "api/labels.h"
#include "booleans/body/canonical.h"
#include "booleans/body/measure.h"
#include "booleans/edges.h"
#include "booleans/shell_forest.h"
#include "grid/lists/stretches.h"

namespace quoin {

using exact::Integer;
using exact::Rational;

namespace {

template <class Number>
std::string text_of(const Number& number) {
  return exact::to_integer(number).str();
}

}  // namespace

struct Boundary::Data {
  Data(const Solid& s, booleans::Boundary&& f)
      : grid(s.grid()),
        form(std::move(f)),
        is_proved(Access::operand(s).is_proved),
        labels(public_labels(form.labels.origins.get(), {form.labels.polygons.data(), form.labels.polygons.size()},
                             form.labels.polygons.size())) {
    if (has_labels(s)) labelled_solid = s;
  }

  const booleans::Edges& edges() const {
    return edges_.get([&] { return booleans::edges_of(form); });
  }
  const booleans::ShellsOfFaces& shells() const {
    return shells_.get([&] { return booleans::shells_of_faces(form, edges()); });
  }
  const booleans::ShellForest& forest() const {
    return forest_.get([&] { return booleans::shell_forest(form, shells()); });
  }

  const Grid grid;
  const booleans::Boundary form;
  const bool is_proved;
  const PublicLabels labels;                 // nothing of faces without any
  std::optional<Solid> labelled_solid = {};  // the solid, if it has labels

  /// Its faces by label. Precondition: it has labels.
  const booleans::LabelledForm& labelled() const {
    return labelled_.get([&] { return booleans::labelled_form(Access::body(*labelled_solid)); });
  }

 private:
  /// A table that is made when it is first asked for. Not by std::call_once, through which nothing can be thrown where
  /// memory is at its end.
  template <class Table>
  class MadeOnce {
   public:
    template <class Make>
    const Table& get(Make&& make) const {
      if (is_made_.load(std::memory_order_acquire)) return table_;
      const std::lock_guard lock(making_);
      if (!is_made_) {
        table_ = make();
        is_made_.store(true, std::memory_order_release);
      }
      return table_;
    }

   private:
    mutable std::atomic<bool> is_made_ = false;
    mutable std::mutex making_;
    mutable Table table_;
  };

  MadeOnce<booleans::Edges> edges_;
  MadeOnce<booleans::ShellsOfFaces> shells_;
  MadeOnce<booleans::ShellForest> forest_;
  MadeOnce<booleans::LabelledForm> labelled_;
};

Boundary::Boundary() : Boundary(Solid().boundary()) {}
Boundary::~Boundary() = default;
Boundary::Boundary(const Boundary&) = default;
Boundary& Boundary::operator=(const Boundary&) = default;
Boundary::Boundary(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

Boundary Solid::boundary(Faces faces) const {
  const booleans::Body& body = Access::body(*this);
  booleans::Boundary form = faces == Faces::by_label ? booleans::labelled_boundary(body) : booleans::canonical(body);
  return Boundary(std::make_shared<const Boundary::Data>(*this, std::move(form)));
}

const Grid& Boundary::grid() const { return data_->grid; }
bool Boundary::is_bounded() const { return !data_->form.full_at_infinity; }

std::uint32_t Boundary::vertex_count() const { return static_cast<std::uint32_t>(data_->form.vertices.size()); }
std::uint32_t Boundary::face_count() const { return static_cast<std::uint32_t>(data_->form.face_count()); }
std::uint32_t Boundary::loop_count() const { return static_cast<std::uint32_t>(data_->form.faces.loop_count()); }
std::uint32_t Boundary::corner_count() const { return static_cast<std::uint32_t>(data_->form.faces.corners.size()); }

// Vertices

std::array<std::string, 4> Boundary::homogeneous(std::uint32_t vertex) const {
  const exact::Point& p = data_->form.vertices[vertex];
  return {text_of(p.x[0]), text_of(p.x[1]), text_of(p.x[2]), text_of(p.w)};
}

std::array<std::string, 3> Boundary::coordinates(std::uint32_t vertex) const {
  const grid::Lattice& lattice = Access::lattice(data_->grid);
  std::array<std::string, 3> r;
  for (int k = 0; k < 3; ++k)
    r[static_cast<std::size_t>(k)] = exact::to_string(grid::model_coordinate(lattice, data_->form.vertices[vertex], k));
  return r;
}

std::array<double, 3> Boundary::point(std::uint32_t vertex) const {
  const grid::Rounder rounder(Access::lattice(data_->grid));
  const exact::Point& p = data_->form.vertices[vertex];
  return {rounder.to_double(p, 0), rounder.to_double(p, 1), rounder.to_double(p, 2)};
}

// Faces

Boundary::Face Boundary::face(std::uint32_t face) const {
  const auto& faces = data_->form.faces;
  const std::uint32_t first = faces.face_start[face], last = faces.face_start[face + 1];
  return {std::span<const std::uint32_t>(faces.loop_start).subspan(first, last - first + 1), faces.corners_of(face)};
}

FaceLabel Boundary::label(std::uint32_t face) const {
  return data_->labels.labels.empty() ? FaceLabel{} : data_->labels.labels[face];
}
const std::vector<Original>& Boundary::originals() const { return data_->labels.originals; }

std::array<std::string, 4> Boundary::plane(std::uint32_t face) const {
  const exact::Plane& p = data_->form.planes[face];
  return {text_of(p.n[0]), text_of(p.n[1]), text_of(p.n[2]), text_of(p.d)};
}

std::array<std::string, 4> Boundary::model_plane(std::uint32_t face) const {
  // A grid coordinate is (x - origin) / step: times the step the normal stays.
  const grid::Lattice& lattice = Access::lattice(data_->grid);
  const exact::Plane& p = data_->form.planes[face];
  Rational offset = lattice.step * exact::to_integer(p.d);
  for (std::size_t k = 0; k < 3; ++k) offset -= p.n[k] * lattice.origin[k];
  return {text_of(p.n[0]), text_of(p.n[1]), text_of(p.n[2]), exact::to_string(offset)};
}

double Boundary::area(std::uint32_t face) const {
  const exact::Plane& plane = data_->form.planes[face];
  const std::size_t k = exact::longest_component(plane.n), u = (k + 1) % 3, v = (k + 2) % 3;
  Rational twice = 0;
  data_->form.faces.for_edges(face, [&](std::uint32_t from, std::uint32_t to) {
    const exact::Point &a = data_->form.vertices[from], &b = data_->form.vertices[to];
    twice += Rational(exact::to_integer(a.x[u] * b.x[v] - b.x[u] * a.x[v]),
                      Integer(exact::to_integer(a.w) * exact::to_integer(b.w)));
  });

  const Rational& step = Access::lattice(data_->grid).step;
  const double projected = std::fabs(exact::to_double(Rational(twice * step * step / 2)));
  const double length = std::fabs(static_cast<double>(plane.n[k]));
  const double x = static_cast<double>(plane.n[u]) / length, y = static_cast<double>(plane.n[v]) / length;
  return projected * std::sqrt(1 + (x * x + y * y));
}

// Edges

std::uint32_t Boundary::edge_count() const { return static_cast<std::uint32_t>(data_->edges().ends.size()); }

Boundary::Edge Boundary::edge(std::uint32_t edge) const {
  const booleans::Edges& edges = data_->edges();
  Edge r{edges.ends[edge], {}};
  for (const std::uint32_t c : edges.fan_of(edge))
    r.fan.push_back({edges.face[c], c, booleans::is_forward(data_->form, edges, c)});
  return r;
}

std::uint32_t Boundary::vertex_of(std::uint32_t corner) const { return data_->form.faces.corners[corner]; }
std::uint32_t Boundary::face_of(std::uint32_t corner) const { return data_->edges().face[corner]; }
std::uint32_t Boundary::next(std::uint32_t corner) const {
  return booleans::next_corner(data_->form, data_->edges(), corner);
}
std::uint32_t Boundary::previous(std::uint32_t corner) const {
  const auto& starts = data_->form.faces.loop_start;
  const std::uint32_t j = data_->edges().loop[corner];
  return corner > starts[j] ? corner - 1 : starts[j + 1] - 1;
}

std::optional<std::uint32_t> Boundary::edge_of(std::uint32_t corner) const {
  const std::uint32_t e = data_->edges().edge[corner];
  return e == booleans::none ? std::nullopt : std::optional(e);
}

std::optional<std::uint32_t> Boundary::opposite(std::uint32_t corner) const {
  return edge_of(corner) ? std::optional(data_->edges().opposite[corner]) : std::nullopt;
}

std::vector<std::uint32_t> Boundary::neighbours(std::uint32_t face) const {
  const Face own = this->face(face);
  std::vector<std::uint32_t> r;
  for (std::uint32_t c = own.starts.front(); c < own.starts.back(); ++c)
    if (const auto other = opposite(c)) r.push_back(face_of(*other));
  return r;
}

// Shells

std::uint32_t Boundary::shell_count() const { return data_->shells().count(); }
std::uint32_t Boundary::shell_of(std::uint32_t face) const { return data_->shells().of_face[face]; }
std::span<const std::uint32_t> Boundary::shell_faces(std::uint32_t shell) const { return data_->shells().faces[shell]; }
std::int64_t Boundary::shell_genus(std::uint32_t shell) const { return data_->shells().genus[shell]; }

std::string Boundary::shell_volume(std::uint32_t shell) const {
  const booleans::Body surface = booleans::body_of(booleans::part_of(data_->form, shell_faces(shell)));
  const Rational& step = Access::lattice(data_->grid).step;
  return exact::to_string(Rational(abs(booleans::volume(surface)) * step * step * step));
}

bool Boundary::is_void(std::uint32_t shell) const { return data_->forest().is_void[shell] != 0; }

std::optional<std::uint32_t> Boundary::parent(std::uint32_t shell) const {
  const std::uint32_t parent = data_->forest().parent[shell];
  return parent == booleans::none ? std::nullopt : std::optional(parent);
}

// Components

std::uint32_t Boundary::component_count() const {
  // All of space is one without shells.
  if (face_count() == 0) return is_bounded() ? 0 : 1;
  return static_cast<std::uint32_t>(data_->forest().shells.size());
}

std::uint32_t Boundary::component_of(std::uint32_t shell) const { return data_->forest().part[shell]; }

namespace {

/// The faces by label of some faces of the canonical form, ascending.
booleans::Boundary part_by_label(const booleans::LabelledForm& form, std::span<const std::uint32_t> faces) {
  std::vector<std::uint32_t> own;
  for (std::uint32_t f = 0; f < form.boundary.face_count(); ++f)
    if (std::binary_search(faces.begin(), faces.end(), form.whole[f])) own.push_back(f);
  return booleans::part_of(form.boundary, own);
}

}  // namespace

Solid Boundary::component(std::uint32_t component) const {
  std::vector<std::uint32_t> faces;
  bool full_at_infinity = !is_bounded();
  if (face_count() > 0)
    for (const std::uint32_t s : data_->forest().shells[component]) {
      const auto own = shell_faces(s);
      faces.insert(faces.end(), own.begin(), own.end());
      if (!is_void(s)) full_at_infinity = false;
    }
  std::sort(faces.begin(), faces.end());

  // Where the others touched it faces and edges become one.
  booleans::Boundary part = data_->labelled_solid && !data_->form.labels ? part_by_label(data_->labelled(), faces)
                                                                         : booleans::part_of(data_->form, faces);
  part.full_at_infinity = full_at_infinity;
  booleans::Body body = booleans::body_of(booleans::labelled_boundary(booleans::body_of(part)));
  body.is_proved = data_->is_proved;
  return Access::solid(data_->grid, std::move(body));
}

std::vector<Solid> Boundary::components() const {
  std::vector<Solid> all;
  for (std::uint32_t c = 0; c < component_count(); ++c) all.push_back(component(c));
  return all;
}

// Arrays

namespace {

/// The loops of a boundary, in an Array as in a vector.
template <class Arrays>
void add_loops(const grid::Loops<std::uint32_t>& faces, Arrays& arrays) {
  arrays.face_starts.assign(faces.face_start.begin(), faces.face_start.end());
  arrays.loop_starts.assign(faces.loop_start.begin(), faces.loop_start.end());
  arrays.corners.assign(faces.corners.begin(), faces.corners.end());
}

}  // namespace

Polygons Boundary::to_polygons() const {
  Polygons r;
  const grid::Rounder rounder(Access::lattice(data_->grid));
  for (const exact::Point& p : data_->form.vertices)
    for (int k = 0; k < 3; ++k) r.points.push_back(rounder.to_double(p, k));
  add_loops(data_->form.faces, r);
  return r;
}

ExactPolygons Boundary::to_exact_polygons() const {
  ExactPolygons r;
  r.grid = data_->grid;
  r.full_at_infinity = data_->form.full_at_infinity;
  for (std::uint32_t v = 0; v < vertex_count(); ++v) r.points.push_back(homogeneous(v));
  for (std::uint32_t f = 0; f < face_count(); ++f) r.planes.push_back(plane(f));
  add_loops(data_->form.faces, r);
  return r;
}

}  // namespace quoin
