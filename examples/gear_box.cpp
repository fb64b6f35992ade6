#include "examples/gear_box.h"

#include <string>

namespace quoin::examples {
namespace {

Model block(const std::string& a, const std::string& b, const std::string& c) { return Model::block({a, b, c}); }

std::string text(int v) { return std::to_string(v); }

/// A disc with trapezoid teeth about the z-axis.
Model gear(int teeth, int radius, const std::string& height) {
  std::vector<Model> parts{Model::cylinder(text(radius), height, "48")};
  // A tooth along x, from inside the disc to its tip.
  const Model tooth = Model::extrusion({{{{text(radius - 1), "-1.1"},
                                          {text(radius) + "+2", "-0.5"},
                                          {text(radius) + "+2", "0.5"},
                                          {text(radius - 1), "1.1"}}}},
                                       {"0", "0", height});
  for (int i = 0; i < teeth; ++i) parts.push_back(tooth.rotated({"0", "0", "1"}, "360*" + text(i) + "/" + text(teeth)));
  return Model::union_of(std::move(parts)) - Model::cylinder("bore", height, "24");
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
  for (const char* x : {"-24", "20"}) solid.push_back(Model::cylinder("9", "10", "32").translated({x, "0", "0"}));
  std::vector<Model> cuts;
  for (const char* x : {"-24", "20"}) cuts.push_back(Model::cylinder("bore", "20", "24").translated({x, "0", "-1"}));
  for (const auto& [x, y] : screws()) {
    cuts.push_back(Model::cylinder("19/10", "8", "16").translated({x, y, "-1"}));
    // Its corners lie beside those of the hole: what meets by chance does not meet after a motion.
    cuts.push_back(Model::frustum("1", "4", "3", "20").rotated({"0", "0", "1"}, "7").translated({x, y, "5/2"}));
  }
  return Model::difference_of([&] {
    std::vector<Model> terms{Model::union_of(std::move(solid))};
    terms.insert(terms.end(), cuts.begin(), cuts.end());
    return terms;
  }());
}

}  // namespace

Model gear_box() {
  const Model large = gear(60, 28, "12").named("wheel").translated({"-24", "0", "11"});
  const Model small = gear(30, 13, "12").named("pinion").rotated({"0", "0", "1"}, "6").translated({"20", "0", "11"});
  std::vector<Model> parts{housing().named("housing"), large, small};
  // Shafts with flats.
  for (const char* x : {"-24", "20"})
    parts.push_back(Model::intersection_of(
                        {Model::cylinder("bore", "50", "24"), block("20", "20", "50").translated({"-10", "-2", "0"})})
                        .translated({x, "0", "-5"})
                        .named("shaft"));
  return Model::union_of(std::move(parts))
      .named("gear box")
      .with_parameters({{"wall", "4"}, {"bore", "5/2"}})
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
