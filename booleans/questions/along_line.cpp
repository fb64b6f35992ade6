#include "booleans/questions/along_line.h"

#include <algorithm>
#include <cmath>

#include "booleans/questions/pierce.h"

namespace quoin::booleans {
namespace {

using exact::Rational;
using Kind = Piercing::Kind;

/// visit(triangle) for those that the line may meet at parameters >= 0; the visitor may empty the way.
template <class Visit>
void for_candidates(const Index& index, const Line& line, Box& way, Visit&& visit) {
  const auto of_interest = [&](std::size_t, std::uint32_t, const Box& box) { return line.may_meet(box); };
  index.tree().meeting(way, of_interest, visit);
}

constexpr Box nowhere{};

/// The axis and direction in which the way out of the box is shortest.
Line shortest_way_out(const Box& box, const QueryPoint& point) {
  std::size_t axis = 0;
  int direction = 1;
  double least = HUGE_VAL;
  const auto ask = [&](std::size_t k, int d, double way) {
    if (way >= least) return;
    least = way;
    axis = k;
    direction = d;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    ask(k, -1, point.near()[k].high - box.low[k]);
    ask(k, 1, box.high[k] - point.near()[k].low);
  }
  return Line(point, axis, direction);
}

/// Whether the interval of parameters of the triangle holds 0.
bool lies_in(const Index& index, const Line& line, std::uint32_t t) {
  const auto along = parameters_along(index, line, t);
  return along && (*along)[0] <= 0 && (*along)[1] >= 0;
}

/// A triangle's piece of a line.
struct Piece {
  Rational begin, end;
  int jump;
  std::uint32_t triangle;
};

/// The pieces that reach parameters >= 0.
std::vector<Piece> pieces_of(const Index& index, const Line& line) {
  std::vector<Piece> pieces;
  Box way = line.way(index.box());
  for_candidates(index, line, way, [&](std::uint32_t t) {
    const Piercing piercing = pierce(index, line, t);
    if (piercing.kind == Kind::point) {
      if (parameter_sign(index, line, t, piercing.facing) < 0) return;
      const Rational at = parameter(index, line, t);
      pieces.push_back({at, at, piercing.jump, t});
    } else if (piercing.kind == Kind::along) {
      const auto along = parameters_along(index, line, t);
      if (along && (*along)[1] >= 0) pieces.push_back({(*along)[0], (*along)[1], 0, t});
    }
  });
  std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
    return a.begin != b.begin ? a.begin < b.begin : a.triangle < b.triangle;
  });
  return pieces;
}

/// A contact that is not cut off at the ends yet, and the sum of the jumps in it.
struct Joined {
  Contact contact;
  int jump = 0;
};

std::vector<Joined> joined(const Index& index, const std::vector<Piece>& pieces) {
  std::vector<Joined> r;
  for (const Piece& p : pieces) {
    if (r.empty() || p.begin > r.back().contact.end) r.push_back({{p.begin, p.end, 0, 0, {}}});
    Joined& last = r.back();
    last.contact.end = std::max(last.contact.end, p.end);
    last.contact.faces.push_back(index.face_name(p.triangle));
    last.jump += p.jump;
  }
  for (Joined& j : r) {
    auto& faces = j.contact.faces;
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  }
  return r;
}

int side_of(int winding) { return winding > 0 ? 1 : -1; }

/// The faces of a contact that is cut off at one of its ends: those that have a piece within first .. last.
void cut_off(const Index& index, const std::vector<Piece>& pieces, const std::optional<Rational>& last,
             Contact& contact) {
  if (contact.begin < 0) contact.begin = 0, contact.before = 0;
  if (last && contact.end > *last) contact.end = *last, contact.behind = 0;

  contact.faces.clear();
  for (const Piece& p : pieces)
    if (p.begin <= contact.end && p.end >= contact.begin) contact.faces.push_back(index.face_name(p.triangle));
  std::sort(contact.faces.begin(), contact.faces.end());
  contact.faces.erase(std::unique(contact.faces.begin(), contact.faces.end()), contact.faces.end());
}

}  // namespace

int locate(const Index& index, const QueryPoint& point) {
  const Line line = shortest_way_out(index.box(), point);
  Box way = line.way(index.box());
  int winding = index.body().full_at_infinity ? 1 : 0;
  bool is_on = false;
  for_candidates(index, line, way, [&](std::uint32_t t) {
    if (is_on) return;
    const Piercing piercing = pierce(index, line, t);
    if (piercing.kind == Kind::miss) return;
    const int at = piercing.kind == Kind::point ? parameter_sign(index, line, t, piercing.facing) : 1;
    if (at == 0 || (piercing.kind == Kind::along && lies_in(index, line, t))) {
      is_on = true;
      way = nowhere;
    } else if (at > 0) {
      winding += piercing.jump;
    }
  });
  return is_on ? 0 : side_of(winding);
}

Passage passage(const Index& index, const Line& line, const std::optional<Rational>& last) {
  const std::vector<Piece> pieces = pieces_of(index, line);
  std::vector<Joined> all = joined(index, pieces);

  // From infinity back to the start.
  int winding = index.body().full_at_infinity ? 1 : 0;
  for (auto j = all.rbegin(); j != all.rend(); ++j) {
    j->contact.behind = side_of(winding);
    winding += j->jump;
    j->contact.before = side_of(winding);
  }

  Passage r{side_of(winding), {}};
  for (Joined& j : all) {
    Contact& c = j.contact;
    if (last && c.begin > *last) break;
    if (c.begin < 0 || (last && c.end > *last)) cut_off(index, pieces, last, c);
    if (c.begin == 0) r.start = 0;
    r.contacts.push_back(std::move(c));
  }
  return r;
}

}  // namespace quoin::booleans
