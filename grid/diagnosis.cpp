#include "grid/diagnosis.h"

#include <array>
#include <charconv>
#include <cmath>

#include "grid/snap.h"

namespace quoin::grid {
namespace {

/// "1 face is", "2 faces are"
std::string counted(std::uint64_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

double in_model_units(double steps, const Lattice& lattice) {
  return steps == 0 ? 0 : exact::double_above(exact::to_rational(steps) * lattice.step);
}

std::string sentence_of(const Finding& f, const Damage& damage) {
  const std::string size = describe_number(f.size);
  switch (f.kind) {
    case Defect::crack:
      return "a crack up to " + size + " wide: " + counted(f.count, "boundary vertex lies", "boundary vertices lie") +
             " that near another";
    case Defect::t_junction:
      return "T-junctions: " + counted(f.count, "vertex lies", "vertices lie") + " beside a neighbour's edge, up to " +
             size + " away";
    case Defect::duplicate:
      return counted(f.count, "face is", "faces are") + " there more often than the surface needs";
    case Defect::flap:
      return counted(f.count, "face belongs", "faces belong") + " to flaps, which bound nothing";
    case Defect::orientation:
      if (!damage.is_curable)
        return counted(f.count, "edge has", "edges have") + " faces that no turning round makes agree";
      return counted(f.count, "face looks", "faces look") + " the other way than the neighbours";
    case Defect::hole:
      return counted(f.count, damage.is_planar ? "planar hole" : "hole that is not planar",
                     damage.is_planar ? "planar holes" : "holes that are not planar") +
             ", " + (f.count == 1 ? "" : "the largest ") + size + " across";
    case Defect::branch:
      return counted(f.count, "edge has", "edges have") + " an odd number of faces, more than one";
    case Defect::inside_out:
      return counted(f.count, "shell is", "shells are") + " inside out";
  }
  return {};
}

/// `tolerance`: what the cure needs to reach.
std::string cure_of(const Damage& damage, double size) {
  const std::string tolerance = size > 0 ? decimal_above(size) : "";
  switch (damage.kind) {
    case Defect::crack:
      return "weld=" + tolerance;
    case Defect::t_junction:
      return "t-junctions=" + tolerance;
    case Defect::duplicate:
    case Defect::flap:
      return "duplicates";
    case Defect::orientation:
      return damage.is_curable ? "orient" : "";
    case Defect::hole:
      return damage.is_planar ? "caps" : "caps=" + tolerance;
    case Defect::branch:
      return {};
    case Defect::inside_out:
      return "invert-shells";
  }
  return {};
}

std::string deed_of(const Finding& f, const Damage& damage) {
  const std::string size = describe_number(f.size);
  switch (f.kind) {
    case Defect::crack:
      return counted(f.count, "boundary vertex", "boundary vertices") + " welded to another, at most " + size + " away";
    case Defect::t_junction:
      return counted(f.count, "boundary edge", "boundary edges") + " bent to a vertex beside it, at most " + size +
             " away";
    case Defect::duplicate:
      return counted(f.count, "copy of a face", "copies of faces") + " dropped";
    case Defect::flap:
      return counted(f.count, "face of a flap", "faces of flaps") + " dropped";
    case Defect::orientation:
      return counted(f.count, "face", "faces") + " turned round to agree with the neighbours";
    case Defect::hole:
      return counted(f.count, damage.is_planar ? "planar hole" : "hole that is not planar",
                     damage.is_planar ? "planar holes" : "holes that are not planar") +
             " closed, at most " + size + " across";
    case Defect::branch:
      break;
    case Defect::inside_out:
      return counted(f.count, "shell", "shells") + " turned round";
  }
  return {};
}

template <class Sentence>
std::vector<Finding> told(const Array<Damage>& damages, const Lattice& lattice, Sentence&& sentence) {
  std::vector<Finding> findings;
  for (const Damage& damage : damages) {
    Finding f{damage.kind, damage.count, in_model_units(damage.size, lattice)};
    f.where = "near " + describe_point(lattice, damage.where);
    f.cure = cure_of(damage, f.size);
    f.sentence = sentence(f, damage);
    findings.push_back(std::move(f));
  }
  return findings;
}

}  // namespace

std::string decimal_above(double value) {
  double above = value;
  for (;;) {
    std::array<char, 32> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), above, std::chars_format::scientific, 2).ptr;
    double rounded = 0;
    std::from_chars(buffer.data(), end, rounded);
    const std::string text = describe_number(rounded);
    // The text as an exact number may lie a little below the double.
    if (exact::parse_rational(text).value_or(0) >= exact::to_rational(value)) return text;
    above *= 1.005;
  }
}

std::vector<Finding> findings_of(const Array<Damage>& damages, const Lattice& lattice) {
  return told(damages, lattice, sentence_of);
}

std::vector<Finding> repairs_of(const Array<Damage>& damages, const Lattice& lattice) {
  return told(damages, lattice, deed_of);
}

}  // namespace quoin::grid
