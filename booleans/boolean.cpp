#include "booleans/boolean.h"

#include "booleans/arrangement/check.h"
#include "booleans/assemble/assemble.h"
#include "booleans/dump.h"
#include "booleans/pairs/foreign_pairs.h"
#include "booleans/places.h"
#include "booleans/stages.h"

namespace quoin::booleans {
namespace {

Error inconsistent(const Arrangement& a, const Selection& selection) {
  const NodeId n = selection.contradiction;
  return {ErrorCode::inconsistent,
          "the surfaces do not bound a solid: an operand that was trusted crosses itself or is not closed",
          {},
          n == none ? "" : in_grid_steps(place_of(a, n).corner)};
}

/// Developer builds look at what a stage made of proved operands; a violation stops the program.
template <class Value, class... Context>
void checked(bool are_proved, const Value& value, const Context&... context) {
  if constexpr (exact::checked)
    if (are_proved) check(value, context...);
}

}  // namespace

Result<Body> evaluate(std::span<const Body* const> operands, const Expression& expression, const Run& run,
                      std::shared_ptr<const Origins> origins) {
  if (!run.begin("pairs", 0.0)) return cancelled();
  Operands all({operands.begin(), operands.end()}, true, std::move(origins));
  const FacePairs pairs = foreign_pairs(all);
  if (run.pairs) *run.pairs += pairs.size();
  dump_if_asked("pairs", [&] { return dump(pairs, all); });

  const Result<Arrangement> a = arrange(std::move(all), pairs, run);
  if (!a) return a.error();
  return selected(a.value(), expression, run);
}

Result<Arrangement> arrange(Operands operands, const FacePairs& pairs, const Run& run) {
  Names names;
  if (!run.begin("touched", 0.2)) return cancelled();
  Touched touched = collect_touched(operands, pairs, names);
  checked(operands.are_proved, touched, names);
  dump_if_asked("touched", [&] { return dump(touched, names); });

  if (!run.begin("contacts", 0.3)) return cancelled();
  const Contacts contacts = find_contacts(touched, touched_pairs(touched, pairs), names);
  dump_if_asked("contacts", [&] { return dump(contacts, names); });

  if (!run.begin("sheets", 0.5)) return cancelled();
  Sheets sheets = draw_sheets(touched, contacts, names);
  for (const Sheet& s : sheets) checked(operands.are_proved, s, names);
  dump_if_asked("sheets", [&] { return dump(sheets, names); });

  if (!run.begin("uses", 0.7)) return cancelled();
  Uses uses = collect_uses(operands, touched, sheets, names);
  Arrangement a{std::move(operands), std::move(names), std::move(touched), std::move(sheets), std::move(uses)};
  checked(a.operands.are_proved, a);
  dump_if_asked("uses", [&] { return dump(a.uses, a.names); });
  return a;
}

Result<Body> selected(const Arrangement& a, const Expression& expression, const Run& run) {
  if (!run.begin("cells", 0.8)) return cancelled();
  const Cells cells = find_cells(a);
  dump_if_asked("cells", [&] { return dump(cells); });

  if (!run.begin("selection", 0.85)) return cancelled();
  const Selection selection = select(a, cells, expression);
  dump_if_asked("selection", [&] { return dump(selection); });
  if (!selection.is_consistent) return inconsistent(a, selection);

  if (!run.begin("body", 0.9)) return cancelled();
  Body result = assemble(a, selection);
  checked(a.operands.are_proved, result);
  dump_if_asked("body", [&] { return dump(result); });
  run.end();
  return result;
}

}  // namespace quoin::booleans
