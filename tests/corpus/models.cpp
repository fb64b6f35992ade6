#include <array>
#include <fstream>
#include <utility>

#include "examples/gear_box.h"
#include "quoin/quoin.h"
#include "tests/api/long_numbers.h"
#include "tests/corpus/folder.h"

namespace quoin::corpus {
namespace {

constexpr std::array roundings{"best", "naive", "continued-fraction", "lattice", "face-local", "vertices"};

std::string file_of(Folder& folder, const std::string& name, const Model& model) {
  return folder.text(name + ".json", model.to_json() + "\n");
}
std::string add(Folder& folder, const std::string& name, const Model& model, const std::string& options = "") {
  return folder.operation(name, "eval " + file_of(folder, name, model) + options);
}

Model block(const std::string& a, const std::string& b, const std::string& c) { return Model::block({a, b, c}); }

Model frame() {
  return Model::extrusion({{{{"0", "0"}, {"4", "0"}, {"4", "4"}, {"0", "4"}}, {{"1", "1"}, {"2", "1"}, {"1", "2"}}},
                           {{{"5", "0"}, {"6", "0"}, {"5", "1"}}}},
                          {"1", "0", "2"});
}

Model hull() {
  return Model::hull({{"0", "0", "0"},
                      {"6", "0", "1/3"},
                      {"0", "6", "0.1"},
                      {"1", "1", "5"},
                      {"5", "5", "4"},
                      {"2", "2", "2"},
                      {"-1", "3", "7/2"}});
}

std::vector<std::pair<std::string, Model>> primitives() {
  return {
      {"block", block("1", "2", "3")},
      {"wedge", Model::wedge({"2", "3", "4"}, "1")},
      {"prism", Model::prism("7", "1", "3")},
      {"cylinder", Model::cylinder("2", "1/2", "32")},
      {"cylinder_around", Model::cylinder("2", "1/2", "9", Fit::circumscribed)},
      {"cylinder_area", Model::cylinder("2", "1/2", "11", Fit::equal_area)},
      {"frustum", Model::frustum("2", "1", "3", "12")},
      {"cone", Model::cone("1", "3", "15")},
      {"sphere", Model::sphere("3", "16")},
      {"tangent_sphere", Model::tangent_sphere("2", "60")},
      {"torus", Model::torus("3", "1", "16", "8")},
      {"convex", Model::convex(api_test::planes_of_long_numbers())},
      {"hull", hull()},
      {"extrusion", frame()},
      {"half_space", hull() & Model::half_space({"1", "2", "3", "-19/2"})},
      {"beyond", hull() - Model::half_space({"1", "-2", "1/3", "1"})},
  };
}

/// Every primitive as it is, and turned in all ways to round.
void add_primitives(Folder& folder) {
  for (const auto& [name, model] : primitives()) {
    const std::string id = "primitive-" + name;
    add(folder, id, model, " --step 1/1000");
    const Model turned = model.rotated({"1", "2", "3"}, "17.5").translated({"0.1", "1e-2", "1/3"});
    for (const char* rounding : roundings)
      add(folder, id + "-" + rounding, turned, std::string(" --rounding ") + rounding);
    add(folder, id + "-coarse", turned, " --step 1/64");
  }
}

/// Motions of one part with a hole, an edge that is no face's border, and coplanar faces.
void add_motions(Folder& folder) {
  const Model part = examples::bracket_variants()[3];
  const std::array rows{Text3{"0.8660254", "-0.5", "0"}, Text3{"0.5", "0.8660254", "0"}, Text3{"0", "0", "1"}};
  const std::vector<std::pair<std::string, Model>> moved{
      {"translated", part.translated({"1", "-2", "1/3"})},
      {"quarter", part.rotated({"0", "0", "2"}, "90")},
      {"third", part.rotated({"1", "1", "1"}, "120")},
      {"turned", part.turned({"4", "1", "-2", "3"})},
      {"matrix", part.transformed(rows)},
      {"mirrored", part.mirrored({"1", "2", "0"})},
      {"scaled", part.scaled({"2", "3/2", "1/3"})},
      {"composed", part.rotated({"0", "1", "0"}, "30").translated({"1", "0", "0"}).rotated({"0", "1", "0"}, "-29")},
      {"back", part.rotated({"1", "2", "2"}, "37").rotated({"-1", "-2", "-2"}, "37")},
  };
  for (const auto& [name, model] : moved) {
    add(folder, "motion-" + name, model, " --step 1/4096");
    // Faces that coincide after motions.
    add(folder, "motion-" + name + "-pair", model + model.translated({"1/7", "0", "0"}) - part);
  }
  Model spun = part;
  for (int i = 0; i < 300; ++i) spun = spun.rotated({"0", "0", "1"}, "0.036").translated({"0", "0", "1/1000"});
  add(folder, "motion-spun", spun, " --step 1/1024");
}

/// Blocks that share faces, turned together: ten in a row, a grid of them, and the brackets.
void add_neighbours(Folder& folder) {
  std::vector<Model> row, grid;
  for (int i = 0; i < 27; ++i) {
    const auto third = [](int n) { return std::to_string(n) + "/3"; };
    if (i < 10) row.push_back(block("1/3", "1", "1/7").translated({third(i), "0", "0"}));
    grid.push_back(block("1/3", "1/3", "1/3").translated({third(i % 3), third(i / 3 % 3), third(i / 9)}));
  }
  for (const char* angle : {"0", "30", "12.3456", "-100/7"}) {
    const std::string id = std::string("neighbours") + (angle[0] == '-' ? "" : "-") + std::string(angle).substr(0, 3);
    const auto turned = [&](const Model& model) { return model.rotated({"3", "-1", "2"}, angle); };
    add(folder, id + "-row", turned(Model::unite(row)));
    add(folder, id + "-grid", turned(Model::unite(grid)));
    add(folder, id + "-odd", turned(Model::symmetric_difference(grid)), " --step 1/65536");
    add(folder, id + "-brackets", turned(Model::unite(examples::bracket_variants())));
  }
}

/// Drills of many sides through a turned plate: a large face, many operands, parameters.
Model drilled_plate() {
  std::vector<Model> drills;
  for (int i = 0; i < 30; ++i)
    drills.push_back(Model::cylinder("pitch * 2 / 5", "4", "24")
                         .translated({"pitch * " + std::to_string(i % 6) + " + pitch / 2",
                                      "pitch * " + std::to_string(i / 6) + " + pitch / 2", "-1/2"}));
  return Model::difference(block("pitch * 6", "pitch * 5", "3"), drills).with_parameters({{"pitch", "2.5"}});
}

void add_parts(Folder& folder, const std::filesystem::path& sources) {
  const std::string plate = file_of(folder, "plate", drilled_plate());
  folder.operation("part-plate", "eval " + plate);
  folder.operation("part-plate-wide", "eval " + plate + " --set pitch=10/3 --step 1/1000");
  add(folder, "part-plate-turned", drilled_plate().rotated({"1", "1", "0"}, "40"));
  folder.operation("part-plate-cut",
                   "split @part-plate-turned.quoin --plane 1,1,-1,-7 -o @part-plate-above.quoin"
                   " @part-plate-below.quoin");

  const std::string box = file_of(folder, "gear_box", examples::gear_box());
  const std::string whole = folder.operation("part-gear_box", "eval " + box);
  folder.operation("part-gear_box-turned", "eval " + box + " --set turn=7.3 --set wall=3");
  folder.operation("part-gear_box-bore", "eval " + box + " --set bore=3 --set turn=-100/3 --step 1/1000");
  folder.operation("part-gear_box-lattice", "eval " + box + " --rounding lattice");
  add(folder, "part-gear_box-spun", examples::gear_box().rotated({"0", "0", "1"}, "37"));
  folder.operation("part-gear_box-moved", "move " + whole + " --rotate 1,2,3 12.5");
  add(folder, "part-gear_box-half", examples::gear_box() & Model::half_space({"1", "3", "0", "-20"}));

  std::ifstream page(sources / "docs" / "model-format.md");
  std::string text, line;
  while (std::getline(page, line) && line != "```json") continue;
  while (std::getline(page, line) && line != "```") text += line + "\n";
  const std::string bracket = folder.text("documented.json", text);
  folder.operation("part-bracket", "eval " + bracket);
  folder.operation("part-bracket-wide", "eval " + bracket + " --set width=80 --set rib=1/3");
}

void add_refusals(Folder& folder) {
  const Model one = block("1", "1", "1");
  const std::vector<std::pair<std::string, Model>> refused{
      {"formula", block("1+", "1", "1")},
      {"parameter", block("v", "1", "1")},
      {"size", block("0", "1", "1").named("lid")},
      {"axis", one.rotated({"0", "0", "0"}, "1")},
      {"factor", one.scaled({"1", "-1", "1"})},
      {"matrix", one.transformed({Text3{"2", "0", "0"}, Text3{"0", "1", "0"}, Text3{"0", "0", "1"}})},
      {"plane", one & Model::half_space({"0", "0", "0", "1"})},
      {"unbounded", Model::half_space({"0", "0", "1", "1"})},
      {"convex", Model::convex({{"1", "0", "0", "-1"}})},
      {"torus", Model::torus("1", "1")},
      {"outlines", Model::extrusion({{{{"0", "0"}, {"4", "4"}, {"4", "0"}, {"0", "4"}}}}, {"0", "0", "1"})},
      {"far", one.translated({"1e9", "0", "0"})},
      {"vast", block("1e309", "1", "1")},
  };
  for (const auto& [name, model] : refused)
    add(folder, "refused_model-" + name, model, name == "far" ? " --step 1" : "");
  // A primitive so small for its grid that planes rounded one by one do not bound it.
  for (const char* rounding : roundings)
    add(folder, std::string("refused_model-small-") + rounding,
        Model::prism("9", "3/2", "2").rotated({"1", "2", "3"}, "17.5"),
        std::string(" --step 1 --rounding ") + rounding);
}

}  // namespace

void add_models(Folder& folder, const std::filesystem::path& sources) {
  add_primitives(folder);
  add_motions(folder);
  add_neighbours(folder);
  add_parts(folder, sources);
  add_refusals(folder);
  add(folder, "model-empty", Model());
  add(folder, "model-full", Model::complement(Model()));
  add(folder, "model-outside", Model::complement(hull()));
  add(folder, "model-vast", block("1e340", "1e340", "1e340").rotated({"0", "0", "1"}, "30").with_step("1e336"));
}

}  // namespace quoin::corpus
