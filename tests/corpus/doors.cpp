#include <array>
#include <cmath>
#include <utility>

#include "examples/models.h"
#include "tests/corpus/folder.h"

namespace quoin::corpus {
namespace {

/// An OFF file of the box, as decimals.
std::string box_text(const std::array<std::string, 3>& low, const std::array<std::string, 3>& high,
                     const std::string& faces = "6", const std::string& first = "4 0 2 3 1") {
  std::string text = "OFF\n8 " + faces + " 0\n";
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t k = 0; k < 3; ++k) text += ((i >> k & 1) != 0 ? high[k] : low[k]) + (k < 2 ? " " : "\n");
  }
  return text + first + "\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
}
std::string cube(const std::string& low, const std::string& high) {
  return box_text({low, low, low}, {high, high, high});
}

/// Solids of different grids.
void add_grids(Folder& folder) {
  const std::array<std::pair<const char*, const char*>, 7> grids{{{"mm", "1/1000"},
                                                                  {"third", "1/3"},
                                                                  {"binary", "1/1024"},
                                                                  {"fine", "1/1048576"},
                                                                  {"seventh", "1/7"},
                                                                  {"one", "1"},
                                                                  {"tenth", "0.1"}}};
  const std::string a = folder.mesh("grid-a.off", examples::geodesic_sphere({1, 2, 3}, 20, 5));
  const std::string b = folder.text("grid-b.off", cube("-7", "13"));
  std::vector<std::string> solids, boxes;
  for (const auto& [name, step] : grids) {
    const std::string id = std::string("grid-") + name;
    solids.push_back(folder.operation(id, "convert " + a + " --step " + step));
    boxes.push_back(folder.operation(id + "-box", "convert " + b + " --step " + step));
    folder.operation(id + "-mesh", "difference " + solids.back() + " " + b);
  }
  for (std::size_t i = 0; i < grids.size(); ++i) {
    const std::string id = std::string("grid-") + grids[i].first;
    const std::size_t j = (i + 1) % grids.size(), k = (i + 3) % grids.size();
    folder.operation(id + "-next", "union " + solids[i] + " " + boxes[j]);
    folder.operation(id + "-other", "difference " + solids[i] + " " + boxes[k] + " " + boxes[j]);
    folder.operation(id + "-chosen", "intersection " + solids[i] + " " + boxes[k] + " --step 1/1000");
    folder.operation(id + "-again", "convert " + solids[i] + " --step " + grids[k].second);
  }

  // Far from the origin for their size: the grid's origin is near them.
  const std::string far = folder.mesh("far-away-a.off", examples::icosphere({1048576, -1048576, 3}, 0.01, 3));
  const std::string near = folder.mesh("far-away-b.off", examples::icosphere({1048576.005, -1048576, 3}, 0.01, 3));
  const std::string both = folder.operation("grid-far", "union " + far + " " + near);
  folder.operation("grid-far-chain", "difference " + both + " " + far);
  folder.operation("grid-far-moved", "move " + both + " --translate 1/1024 0 0 --rotate z 90");
}

/// What import seals, counts and refuses.
void add_imports(Folder& folder) {
  const std::array<std::pair<const char*, std::string>, 14> texts{{
      {"decimals", cube("0.1", "0.7")},
      {"bent",
       "OFF\n8 6 0\n0 0 0\n4 0 0\n0 4 0\n4 4 0\n0 0 4\n4 0 4\n0 4 4\n5 5 4\n"
       "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n"},
      {"sliver",
       "OFF\n9 7 0\n0 0 0\n4 0 0\n0 4 0\n4 4 0\n0 0 4\n4 0 4\n0 4 4\n4 4 4\n2 4 4\n"
       "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n5 2 6 8 7 3\n4 0 4 6 2\n4 1 3 7 5\n3 6 7 8\n"},
      {"flat", "OFF\n3 2 0\n0 0 0\n4 0 0\n0 4 0\n3 0 1 2\n3 2 1 0\n"},
      {"world", cube("-536870912", "536870912")},
      {"beyond", cube("-536870912", "536870913")},
      {"tiny", cube("1e-300", "2e-300")},
      {"vast", cube("-1e300", "1e300")},
      {"open", box_text({"0", "0", "0"}, {"1", "1", "1"}, "5")},
      {"turned_over", box_text({"0", "0", "0"}, {"1", "1", "1"}, "6", "4 1 3 2 0")},
      {"inside_out", box_text({"0", "0", "0"}, {"1", "1", "-1"})},
      {"infinite", cube("0", "inf")},
      {"index", box_text({"0", "0", "0"}, {"1", "1", "1"}, "6", "4 0 2 8 1")},
      {"truncated", cube("0", "1").substr(0, 90)},
  }};
  for (const auto& [name, text] : texts) {
    const std::string file = folder.text(std::string("import-") + name + ".off", text);
    folder.operation(std::string("import-") + name, "convert " + file);
    folder.operation(std::string("import-") + name + "-one", "convert " + file + " --step 1");
  }
  folder.operation("import-missing", "union import-decimals.off import-nothing.off");
  folder.operation("import-bad_quoin", "convert " + folder.text("bad.quoin", "quoin 1\ngrid 1 0 0 0\nvertices\n"));
  folder.operation("import-unknown", "convert " + folder.text("what.obj", "what is this\n"));

  // Grids so coarse that faces collapse.
  const std::string torus = folder.mesh("import-torus.off", examples::torus({0.1, 0.2, 0.3}, 3, 1, 30, 20));
  const std::array steps{"1/16", "1/5", "1/3", "1/2", "1", "3"};
  for (std::size_t i = 0; i < steps.size(); ++i)
    folder.operation("import-coarse-" + std::to_string(i), "convert " + torus + " --step " + steps[i]);
  folder.operation("import-trusted", "union " + torus + " import-sliver.off --trust");
}

/// Motions and cuts of solids without history.
void add_motions(Folder& folder) {
  const std::string ball = folder.mesh("moved-ball.off", examples::geodesic_sphere({0.5, 0, 0}, 1, 6));
  examples::Gear gear;
  gear.teeth = 9;
  const std::string wheel = folder.mesh("moved-gear.off", examples::gear(gear));
  const std::string flat = folder.text("moved-box.off", box_text({"0", "-1", "0"}, {"3", "1/2", "2"}));
  const std::array<std::pair<const char*, std::string>, 4> solids{{
      {"ball", folder.operation("moved-ball", "convert " + ball + " --step 1/65536")},
      {"gear", folder.operation("moved-gear", "convert " + wheel + " --step 1/1000")},
      {"carved", folder.operation("moved-carved", "difference " + ball + " " + wheel)},
      {"outside", folder.operation("moved-outside", "complement " + wheel)},
  }};
  const std::array<std::pair<const char*, const char*>, 10> motions{{
      {"quarter", "--rotate z 90"},
      {"third", "--rotate 1,1,1 120"},
      {"angle", "--rotate 1,2,3 12.5"},
      {"composed", "--rotate x 30 --translate 1/3 -0.25 2 --rotate x -29.5 --rotate y 1e-3"},
      {"full", "--rotate z 123.4 --rotate z 236.6"},
      {"mirror", "--mirror 1,2,0"},
      {"scale", "--scale 2,3/2,1/3"},
      {"naive", "--rotate 3,1,-2 77 --rounding naive"},
      {"face_local", "--rotate 3,1,-2 77 --rounding face-local"},
      {"vertices", "--rotate 3,1,-2 77 --rounding vertices"},
  }};
  for (const auto& [solid, file] : solids)
    for (const auto& [motion, words] : motions)
      folder.operation(std::string("moved-") + solid + "-" + motion, "move " + file + " " + words);
  folder.operation("moved-both", "union @moved-carved.quoin @moved-carved-angle.quoin");
  folder.operation("moved-bad_number", "convert " + flat);
  folder.operation("moved-far", "move @moved-gear.quoin --translate 1e9 0 0");
  folder.operation("moved-vast", "move @moved-gear.quoin --scale 1e9");

  const std::array<const char*, 6> planes{"0,0,1,0",   "1,2,3,-1/2",   "1,0,0,-0.5",
                                          "1,1,1,100", "-3,1/7,2,1/3", "0,0,1,-1/4"};
  for (const auto& [solid, file] : solids)
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const std::string id = std::string("cut-") + solid + "-" + std::to_string(i);
      folder.operation(
          id, "split " + file + " --plane " + planes[i] + " -o @" + id + "-above.quoin @" + id + "-below.quoin");
      folder.operation(id + "-whole", "union @" + id + "-above.quoin @" + id + "-below.quoin");
    }
  folder.operation("cut-bad_plane", "split @moved-gear.quoin --plane 1,2 -o @cut-a.quoin @cut-b.quoin");
  folder.operation("cut-long_plane",
                   "split @moved-gear.quoin --plane 1,0,0.12345678901234567890123,1/3 -o @cut-c.quoin"
                   " @cut-d.quoin");
}

/// Solids as triangles, in every format, and back.
void add_exports(Folder& folder) {
  const std::string ball = folder.mesh("export-ball.off", examples::bumpy_sphere({0, 0, 0}, 1, 1200, 5));
  const std::string tools =
      folder.mesh("export-tools.off", examples::joined(examples::needles(6, {0, 0, 0}, 2, 0.1, 5, 4)));
  const std::string touching = folder.mesh("export-cells.off", examples::joined(examples::menger_cells(1)));
  const std::string corner = folder.text("export-corner.off", cube("3", "4"));
  const std::array solids{
      folder.operation("export-carved", "difference " + ball + " " + tools),
      folder.operation("export-needles", "symmetric-difference " + tools + " " + ball + " --step 1/1000"),
      folder.operation("export-touching", "union " + touching + " " + corner),
  };
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (const char* extension : {"stl", "obj", "off", "ply"})
      for (const char* topology : {"manifold", "indexed"}) {
        const std::string name = "export-" + std::to_string(i) + "-" + topology + "." + extension;
        folder.operation(name, "convert " + solids[i] + " -o @" + name + " --output-topology " + topology);
        folder.operation(name + "-read", "convert @" + name + " --step 1/1048576");
      }
  folder.operation("export-ascii.stl", "convert " + solids[0] + " -o @export-ascii.stl --format stl-ascii");
  folder.operation("export-ascii.ply", "convert " + solids[1] + " -o @export-ascii.ply --format ply-ascii");
  const std::string outside = folder.operation("export-outside", "complement " + solids[0]);
  folder.operation("export-unbounded.off", "convert " + outside + " -o @export-unbounded.off");
  const std::string nothing = folder.operation("export-nothing", "difference " + solids[0] + " " + solids[0]);
  folder.operation("export-nothing.off", "convert " + nothing + " -o @export-nothing.off");
  folder.operation("export-everything", "union " + outside + " " + solids[0]);
}

}  // namespace

void add_doors(Folder& folder) {
  add_grids(folder);
  add_imports(folder);
  add_motions(folder);
  add_exports(folder);
}

}  // namespace quoin::corpus
