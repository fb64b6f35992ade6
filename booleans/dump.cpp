#include "booleans/dump.h"

#include <cstdarg>
#include <cstdlib>
#include <cstring>

#include "exact/rational.h"

namespace quoin::booleans {
namespace {

/// Text that grows line by line.
class Lines {
 public:
  [[gnu::format(printf, 2, 3)]] void add(const char* format, ...) {
    std::va_list arguments;
    va_start(arguments, format);
    std::array<char, 256> line{};
    std::vsnprintf(line.data(), line.size(), format, arguments);
    va_end(arguments);
    text_ += line.data();
  }
  void add(const std::string& s) { text_ += s; }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::string text_of(const std::array<double, 3>& p) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "(%g, %g, %g)", p[0], p[1], p[2]);
  return text.data();
}
std::string text_of(const Names& names, VertexId v) { return text_of(names.vertices.approximation(v)); }
std::string text_of(const exact::Plane& p) {
  return "[" + std::to_string(p.n[0]) + " " + std::to_string(p.n[1]) + " " + std::to_string(p.n[2]) + " " +
         exact::to_integer(p.d).str() + "]";
}

}  // namespace

std::string dump(const FacePairs& pairs, const Operands& operands) {
  Lines out;
  for (const FacePair& p : pairs) {
    const OwnFace f = operands.own(p[0]), g = operands.own(p[1]);
    out.add("%u.%u - %u.%u\n", f.operand.value, f.face, g.operand.value, g.face);
  }
  return out.take();
}

std::string dump(const Touched& touched, const Names& names) {
  Lines out;
  for (const TouchedId t : Ids<TouchedId>(touched.faces.size())) {
    const TouchedFace& f = touched.faces[t];
    const exact::Plane& p = names.planes[f.plane];
    out.add("face %u of operand %u on ", t.value, f.operand.value);
    out.add(text_of(f.along ? p : p.opposite()) + "\n");
    for (const BoundaryEdge& e : touched.edges_of(t))
      out.add("  " + text_of(names, e.from) + " -> " + text_of(names, e.to) + "\n");
    for (const VertexId v : touched.isolated_of(t)) out.add("  point " + text_of(names, v) + "\n");
  }
  return out.take();
}

std::string dump(const Contacts& contacts, const Names& names) {
  Lines out;
  for (const ContactSegment& s : contacts.segments) {
    const bool forward = names.vertices.compare_lexicographic(s.a, s.b) < 0;
    out.add("on " + text_of(names.planes[s.plane]) + ": " + text_of(names, forward ? s.a : s.b) + " - " +
            text_of(names, forward ? s.b : s.a) + "\n");
  }
  for (const ContactPoint& p : contacts.points)
    out.add("on " + text_of(names.planes[p.plane]) + ": " + text_of(names, p.vertex) + "\n");
  return out.take();
}

std::string dump(const Sheets& sheets, const Names& names) {
  Lines out;
  for (const SheetId s : sheets.ids()) {
    const Sheet& sheet = sheets[s];
    out.add("sheet " + text_of(names.planes[sheet.plane]) + "\n");
    for (const FacetId f : Ids<FacetId>(sheet.facet_count())) {
      out.add("  facet %u of", sheets.node(s, f).value);
      for (const TouchedId t : sheet.covers(f)) out.add(" %u", t.value);
      out.add("\n");
      for (std::uint32_t h = 0; h < sheet.half_edges(); ++h)
        if (sheet.facet[h] == f)
          out.add("    " + text_of(names, sheet.origin(h)) + " -> " + text_of(names, sheet.target(h)) + "\n");
    }
    for (const Sheet::Isolated& i : sheet.isolated)
      out.add("  point " + text_of(names, i.vertex) + " in facet " + std::to_string(sheets.node(s, i.facet).value) +
              "\n");
  }
  return out.take();
}

std::string dump(const Uses& uses, const Names& names) {
  Lines out;
  uses.for_edges([&](VertexId low, std::span<const Use> at) {
    out.add(text_of(names, low) + " - " + text_of(names, at[0].high()) + ":");
    for (const Use& u : at)
      out.add(" %s%u%s", u.is_facet() ? "" : "patch ", u.node().value, u.left() ? " left" : " right");
    out.add("\n");
  });
  return out.take();
}

std::string dump(const Cells& cells) {
  Lines out;
  const auto name = [&](CellId c) { return c == cells.infinity ? std::string("infinity") : std::to_string(c.value); };
  for (std::uint32_t n = 0; 2 * n < cells.of.size(); ++n)
    out.add(std::to_string(n) + ": " + name(cells.of[front_of(n)]) + ", " + name(cells.of[back_of(n)]) + "\n");
  return out.take();
}

std::string dump(const Selection& selection) {
  Lines out;
  for (const NodeId n : Ids<NodeId>(selection.kept.size())) out.add("%u: %d\n", n.value, int{selection.kept[n]});
  out.add("infinity: %d\n", selection.full_at_infinity ? 1 : 0);
  if (!selection.is_consistent) out.add("inconsistent\n");
  return out.take();
}

std::string dump(const Body& body) {
  Lines out;
  body.for_runs([&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t f = begin; f < end; ++f) {
      out.add("face on " + text_of(body.plane(f)) + "\n");
      const auto add_loop = [&](std::span<const std::uint32_t> loop) {
        out.add(" ");
        for (const std::uint32_t v : loop) out.add(" " + text_of(body.approximation(v)));
        out.add("\n");
      };
      if (f < body.triangles.size())
        add_loop(body.corners_of(f));
      else
        body.polygons.for_loops(body.polygon(f), add_loop);
    }
  });
  if (body.full_at_infinity) out.add("full at infinity\n");
  return out.take();
}

#ifdef QUOIN_CHECKED
bool is_dump_asked(const char* stage) {
  const char* text = std::getenv("QUOIN_DUMP");
  if (!text) return false;
  const std::string all = "," + std::string(text) + ",";
  return all.find("," + std::string(stage) + ",") != std::string::npos;
}
#endif

}  // namespace quoin::booleans
