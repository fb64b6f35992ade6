// Shells of a solid, and a walk around a face: the example of docs/boundary.md.
#include <quoin/quoin.h>

#include <cstdint>
#include <cstdio>

int main() {
  using quoin::Model;
  const Model block = Model::block({"4", "4", "4"}), room = Model::block({"2", "2", "2"}).translated({"1", "1", "1"});
  const quoin::Boundary b = quoin::evaluate(block - room).value().boundary();

  for (std::uint32_t s = 0; s < b.shell_count(); ++s)
    std::printf("shell %u is a %s of volume %s\n", s, b.is_void(s) ? "void" : "solid", b.shell_volume(s).c_str());

  // Once around a face, with the faces beyond its edges.
  const std::uint32_t first = b.face(0).first_corner();
  std::uint32_t corner = first;
  do {
    const auto p = b.coordinates(b.vertex_of(corner));
    std::printf("(%s, %s, %s), face %u\n", p[0].c_str(), p[1].c_str(), p[2].c_str(), b.face_of(*b.opposite(corner)));
    corner = b.next(corner);
  } while (corner != first);
}
