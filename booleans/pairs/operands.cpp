#include "booleans/pairs/operands.h"

namespace quoin::booleans {
namespace {

/// The numbers of a body's origins among others that hold them; nothing where they are the same.
Array<std::uint32_t> places_of_origins(const Body& body, const Origins& all) {
  if (!body.labels) return {all.find(nullptr)};
  const Origins& own = *body.labels.origins;
  if (&own == &all) return {};

  Array<std::uint32_t> places;
  places.reserve(own.size());
  bool are_same = true;
  for (std::uint32_t i = 0; i < own.size(); ++i) {
    places.push_back(i < all.size() && all[i] == own[i] ? i : all.find(own[i]));
    are_same = are_same && places[i] == i;
  }
  if (are_same) places.clear();
  return places;
}

}  // namespace

Operands::Operands(std::vector<const Body*> list, bool clean, std::shared_ptr<const Origins> joint)
    : base{FaceId(0)},
      first_chunk{0},
      are_clean(clean),
      origins(joint ? std::move(joint) : joint_origins(list)),
      origins_of(origins ? list.size() : 0) {
  bodies.assign(list.begin(), list.end());
  bounds.reserve(list.size());
  base.reserve(list.size() + 1);
  first_chunk.reserve(list.size() + 1);
  Array<Chunk> made;

  for (const OperandId o : ids()) {
    const Body& body = (*this)[o];
    are_proved = are_proved && body.is_proved;
    if (origins) origins_of[o] = places_of_origins(body, *origins);
    const auto faces = static_cast<std::uint32_t>(body.face_count());
    made.clear();
    if (body.chunks.empty()) add_chunks(body, 0, faces, made);

    Box& all = bounds.emplace_back();
    for (const Chunk& c : body.chunks.empty() ? made : body.chunks) {
      chunks.push_back({face(o, c.begin), face(o, c.end), c.box, o, false});
      all.add(c.box);
    }
    base.push_back(base.back().value + faces);
    first_chunk.push_back(static_cast<std::uint32_t>(chunks.size()));
  }

  for (OperandChunk& c : chunks) c.far = !may_be_near(c.operand, c.box);
}

Array<Chunk> Operands::chunks_meeting(OperandId operand, std::span<const Box> boxes) const {
  Array<Chunk> found;
  for (const OperandChunk& c : chunks_of(operand))
    if (std::any_of(boxes.begin(), boxes.end(), [&](const Box& b) { return c.box.meets(b); }))
      found.push_back({own(operand, c.begin), own(operand, c.end), c.box});
  return found;
}

std::shared_ptr<const Origins> joint_origins(std::span<const Body* const> bodies) {
  const Body* largest = nullptr;
  bool any = false;
  for (const Body* body : bodies) {
    any = any || body->labels;
    if (!largest || body->face_count() > largest->face_count()) largest = body;
  }
  if (!any) return nullptr;

  auto all = largest->labels ? std::make_shared<Origins>(*largest->labels.origins) : std::make_shared<Origins>();
  Array<std::uint32_t> order;
  Array<std::uint8_t> is_listed(all->size());
  const auto list = [&](std::uint32_t origin) {
    if (!is_listed[origin]) order.push_back(origin);
    is_listed[origin] = 1;
  };
  const auto list_equal = [&](const Origins::Pointer& origin) {
    const std::uint32_t place = all->find(origin);
    if (place == all->size()) {
      all->add(origin);
      is_listed.push_back(0);
    }
    list(place);
  };
  for (const Body* body : bodies) {
    if (!body->labels) {
      list_equal(nullptr);
      continue;
    }
    for (const std::uint32_t i : body->labels.origins->in_order())
      body == largest ? list(i) : list_equal((*body->labels.origins)[i]);
  }
  all->set_order(order);
  return all;
}

}  // namespace quoin::booleans
