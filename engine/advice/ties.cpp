#include "engine/advice/ties.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

template <typename Part>
bool acts(const Part& part, std::size_t stage) {
  return static_cast<std::size_t>(part.first_stage) <= stage && !part.withdrawal.is_over_in(stage);
}

// A grouted bolt gives way at the joint alone, over the rock that is drawn with it.
double length_of(const BoltLink& link) { return (link.point_b - link.point_a).norm() + link.reach_a + link.reach_b; }

}  // namespace

std::vector<Tie> ties_in(const Model& model, std::size_t stage) {
  std::vector<Tie> ties;
  for (const Bolt& bolt : model.bolts) {
    if (!acts(bolt, stage)) continue;
    for (const BoltLink& link : bolt.links)
      ties.push_back({fmt::format("bolt \"{}\"", bolt.name),
                      {link.block_a, {link.point_a, link.point_b}},
                      std::max(link.axial_stiffness, link.shear_stiffness) * length_of(link),
                      length_of(link)});
  }
  for (const Lining& lining : model.linings) {
    if (!acts(lining, stage)) continue;
    const double stiffness = lining.young * lining.thickness / (1 - std::pow(lining.poisson, 2));
    for (std::size_t i = 0; i < lining.elements(); ++i) {
      const LiningNode& start = lining.start_of(i);
      const Vec2& end = lining.end_of(i).point;
      ties.push_back({fmt::format("lining \"{}\"", lining.name),
                      {start.block, {start.point, end}},
                      stiffness,
                      (end - start.point).norm()});
    }
  }
  return ties;
}

}  // namespace dda
