#include "engine/advice/lining_remarks.h"

#include <fmt/format.h>

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
constexpr double to_degrees = 180 / std::numbers::pi;

struct Course {
  double length = 0;           // m
  double turn = 0;             // rad, of its end against its start
  double sharpest = 0;         // rad, between neighbouring faces
  Vec2 corner = Vec2::Zero();  // where that is
};

Course course_of(const Lining& lining) {
  Course course;
  for (std::size_t i = 0; i < lining.elements(); ++i) {
    const double turn = angle_between(lining.start_of(i).tangent, lining.end_of(i).tangent);
    course.length += chord_of(lining, i).norm();
    course.turn += turn;
    if (std::abs(turn) <= course.sharpest) continue;
    course.sharpest = std::abs(turn);
    course.corner = middle_of(lining, i);
  }
  return course;
}

void remark_on(const Lining& lining, std::vector<std::string>& remarks) {
  const Course course = course_of(lining);
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
