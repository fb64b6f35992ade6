#include "examples/gear_box.h"

#include <string>

namespace quoin::examples {
namespace {

Model block(const std::string& a, const std::string& b, const std::string& c) { return Model::block({a, b, c}); }

std::string text(int v) { return std::to_string(v); }

/// Along x, of the large gear and the small one.
constexpr const char* gear_places[] = {"-24", "25/2"};

/// A disc with trapezoid teeth about the z-axis.
Model gear(int teeth, int radius, const std::string& height) {
  std::vector<Model> parts{Model::cylinder(text(radius), height, "48")};
  // A tooth along x, from inside the disc to its tip.
  const Model tooth = Model::extrusion({{{{text(radius - 1), "-0.85"},
                                          {text(radius) + "+2", "-0.35"},
                                          {text(radius) + "+2", "0.35"},
                                          {text(radius - 1), "0.85"}}}},
                                       {"0", "0", height});
  for (int i = 0; i < teeth; ++i) parts.push_back(tooth.rotated({"0", "0", "1"}, "360*" + text(i) + "/" + text(teeth)));
  return Model::unite(std::move(parts)) - Model::cylinder("bore", height, "24");
}

/// The screws' places along the flange of the lower half.
std::vector<std::array<std::string, 2>> screws() {
  std::vector<std::array<std::string, 2>> places;
  for (int i = 0; i < 8; ++i)
    for (const char* y : {"-34", "34"}) places.push_back({text(-56 + 16 * i) + "+1/7", y});
  for (int i = 0; i < 3; ++i)
    for (const char* x : {"-66", "66"}) places.push_back({x, text(-16 + 16 * i) + "+1/11"});
  return places;
}

Model housing() {
  const Model shell = block("120", "60", "40").translated({"-60", "-30", "0"}) -
                      block("120-2*wall", "60-2*wall", "40").translated({"-60+wall", "-30+wall", "wall"});
  std::vector<Model> solid{shell,
                           block("140", "76", "5").translated({"-70", "-38", "0"}) -
                               block("120-2*wall", "60-2*wall", "5").translated({"-60+wall", "-30+wall", "wall"})};
  // Fins outside, tapering.
  for (int i = 0; i < 24; ++i)
    for (const int side : {-1, 1})
      solid.push_back(
          Model::wedge({"2", "10", "30"}, "1").translated({"-59+5*" + text(i), side > 0 ? "27" : "-37", "5"}));
  for (const char* x : {"-70", "60"})
    for (const char* y : {"-38", "28"}) solid.push_back(block("10", "10", "3").translated({x, y, "-3"}));
  // Bearing bosses, inside the floor.
  for (const char* x : gear_places) solid.push_back(Model::cylinder("9", "10", "32").translated({x, "0", "0"}));
  std::vector<Model> cuts;
  for (const char* x : gear_places) cuts.push_back(Model::cylinder("bore+1/4", "20", "24").translated({x, "0", "-1"}));
  for (const auto& [x, y] : screws()) {
    cuts.push_back(Model::cylinder("19/10", "8", "16").translated({x, y, "-1"}));
    // Its corners lie beside those of the hole: what meets by chance does not meet after a motion.
    cuts.push_back(Model::frustum("1", "4", "3", "20").rotated({"0", "0", "1"}, "7").translated({x, y, "5/2"}));
  }
  return Model::difference(Model::unite(std::move(solid)), std::move(cuts));
}

}  // namespace

Model gear_box() {
  // Shafts with flats turn with their gears, and touch nothing else.
  const Model shaft =
      Model::intersect({Model::cylinder("bore", "50", "24"), block("20", "20", "50").translated({"-10", "-2", "0"})})
          .translated({"0", "0", "-5"})
          .named("shaft");
  const auto turned = [&](const Model& gear, const std::string& angle, const char* x) {
    return (gear.translated({"0", "0", "11"}) + shaft).rotated({"0", "0", "1"}, angle).translated({x, "0", "0"});
  };
  const std::vector<Model> parts{housing().named("housing"),
                                 turned(gear(60, 23, "12").named("wheel"), "turn", gear_places[0]),
                                 turned(gear(30, 11, "12").named("pinion"), "6-2*turn", gear_places[1])};
  return Model::unite(parts)
      .named("gear box")
      .with_parameters({{"wall", "4"}, {"bore", "5/2"}, {"turn", "0"}})
      .with_step("1/65536");
}

std::vector<Model> bracket_variants() {
  const Model angle = block("1", "4", "8") + block("8", "4", "1").translated({"1", "0", "0"});
  const Model square = block("2", "2", "1").translated({"4", "1", "0"});
  const Model round = Model::cylinder("1", "1", "32").translated({"5", "2", "0"});
  const Model rib = Model::extrusion({{{{"0", "0"}, {"5", "0"}, {"0", "5"}}}}, {"0", "0", "1"})
                        .rotated({"1", "0", "0"}, "90")
                        .translated({"1", "5/2", "1"});
  return {angle - square, angle - round, angle + rib, (angle + rib) - round};
}

}  // namespace quoin::examples
