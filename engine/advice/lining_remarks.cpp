#include "engine/advice/lining_remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "engine/model/lining_chord.h"
#include "engine/terms/lining.h"

namespace dda {
namespace {

constexpr double thickest = 0.1;                          // of the wall's radius: beyond, a beam is no thin ring
constexpr double sharpest_corner = std::numbers::pi / 6;  // rad, between neighbouring faces
constexpr double shortest_element = 1;                    // of the thickness, on average
constexpr double most_uneven = 0.5;                       // shortest element over the mean
constexpr double softest_concrete = 1e8;                  // Pa: sprayed concrete of an hour has more
constexpr double weakest_concrete = 1e4;                  // Pa
constexpr double stiffest_steel = 1e12;                   // Pa, with room: steel has 210 GPa
constexpr double thinnest = 1e-3;                         // m: sheets and membranes
constexpr double to_degrees = 180 / std::numbers::pi;

struct Course {
  double length = 0;                                          // m
  double shortest = std::numeric_limits<double>::infinity();  // m, of its elements
  double turn = 0;                                            // rad, of its end against its start
  double sharpest = 0;                                        // rad, between neighbouring faces
  Vec2 corner = Vec2::Zero();                                 // where that is
};

Course course_of(const Lining& lining) {
  Course course;
  for (std::size_t i = 0; i < lining.elements(); ++i) {
    const double turn = angle_between(lining.start_of(i).tangent, lining.end_of(i).tangent);
    const double length = chord_of(lining, i).norm();
    course.length += length;
    course.shortest = std::min(course.shortest, length);
    course.turn += turn;
    if (std::abs(turn) <= course.sharpest) continue;
    course.sharpest = std::abs(turn);
    course.corner = middle_of(lining, i);
  }
  return course;
}

// A number without its unit is in Pa: "15" for 15 GPa.
void remark_on_numbers(const Lining& lining, std::vector<std::string>& remarks) {
  if (lining.young < softest_concrete)
    remarks.push_back(
        fmt::format("lining \"{}\" has a young of {:g} Pa: concrete has 1 to 40 GPa, and green concrete "
                    "0.1 GPa and more",
                    lining.name, lining.young));
  if (lining.young > stiffest_steel)
    remarks.push_back(fmt::format("lining \"{}\" has a young of {:g} Pa: concrete has 1 to 40 GPa, steel 210 GPa",
                                  lining.name, lining.young));
  if (lining.thickness < thinnest)
    remarks.push_back(fmt::format("lining \"{}\" is {:.3g} m thick, thinner than any sheet of concrete or steel",
                                  lining.name, lining.thickness));
  if (lining.compressive_strength < weakest_concrete)
    remarks.push_back(fmt::format("lining \"{}\" has a compressive_strength of {:g} Pa: concrete has 1 to 100 MPa",
                                  lining.name, lining.compressive_strength));
  if (lining.yields() && lining.tensile_strength > lining.compressive_strength)
    remarks.push_back(
        fmt::format("lining \"{}\" is stronger in tension, {:g} Pa, than in compression, {:g} Pa: concrete "
                    "has about a tenth in tension",
                    lining.name, lining.tensile_strength, lining.compressive_strength));
}

// Blocks have one strain each, so the face of each turns by its own gradient: where neighbours differ in shape their
// turns do, by some of the strain, however small they are, and that difference over the length is taken for bending.
void remark_on_evenness(const Lining& lining, const Course& course, std::vector<std::string>& remarks) {
  const double mean = course.length / static_cast<double>(lining.elements());
  if (course.shortest >= most_uneven * mean) return;
  remarks.push_back(fmt::format(
      "lining \"{}\": faces of blocks are of uneven lengths, {:.3g} m from middle to middle at least and {:.3g} m on "
      "average: its moments and utilisation in single elements are then many times too large where rock strains "
      "without slipping; take means of moments over ten elements and more, or a wall of even faces (\"rings\" of the "
      "opening)",
      lining.name, course.shortest, mean));
}

void remark_on(const Lining& lining, std::vector<std::string>& remarks) {
  const Course course = course_of(lining);
  remark_on_numbers(lining, remarks);
  remark_on_evenness(lining, course, remarks);
  const double radius =
      course.turn == 0 ? std::numeric_limits<double>::infinity() : course.length / std::abs(course.turn);
  if (lining.thickness > thickest * radius)
    remarks.push_back(
        fmt::format("lining \"{}\" is {:.3g} m thick on a wall with a mean radius of {:.3g} m: it is reckoned as a "
                    "thin beam on the "
                    "wall, which holds up to a tenth of the radius",
                    lining.name, lining.thickness, radius));
  if (course.sharpest > sharpest_corner)
    remarks.push_back(fmt::format(
        "lining \"{}\" cuts a corner of {:.0f} degrees near [{:.4g}, {:.4g}]: it runs straight from the middle of one "
        "face of a block to the middle of the next, so smaller blocks there follow the wall better",
        lining.name, to_degrees * course.sharpest, course.corner.x(), course.corner.y()));
  const double mean_length = course.length / static_cast<double>(lining.elements());
  if (mean_length < shortest_element * lining.thickness)
    remarks.push_back(fmt::format(
        "lining \"{}\": faces of blocks are {:.3g} m long on average, less than its thickness of {:.3g} m: its moments "
        "follow differences between them, and the wall takes over most of its shear",
        lining.name, mean_length, lining.thickness));
}

}  // namespace

std::vector<std::string> lining_remarks(const Model& model) {
  std::vector<std::string> remarks;
  for (const Lining& lining : model.linings) remark_on(lining, remarks);
  return remarks;
}

}  // namespace dda
