#include "booleans/pairs/operands.h"

namespace quoin::booleans {

Operands::Operands(std::vector<const Body*> list, bool clean) : base{FaceId(0)}, first_chunk{0}, are_clean(clean) {
  bodies.assign(list.begin(), list.end());
  bounds.reserve(list.size());
  base.reserve(list.size() + 1);
  first_chunk.reserve(list.size() + 1);
  Array<Chunk> made;

  for (const OperandId o : ids()) {
    const Body& body = (*this)[o];
    are_proved = are_proved && body.is_proved;
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

}  // namespace quoin::booleans
