#include "engine/advice/bolt_remarks.h"

#include <fmt/format.h>

#include <algorithm>

namespace dda {
namespace {

using Remarks = std::vector<std::string>;

// Bolts have 1e6 (a cable of 30 m) to 1e9 N/m (a short bar of 40 mm), and yield at 50 kN and more.
constexpr double softest = 1e4;          // N/m
constexpr double stiffest_in_rock = 10;  // of Young's modulus of the softer block, per m of thickness
constexpr double weakest = 1e3;          // N
constexpr double most_pretension = 2e7;  // N: the largest anchors of dams have 10 MN

bool is_stiffer_than_rock(const Model& model, const BoltLink& link) {
  const double rock = std::min(model.material_of(link.block_a).young, model.material_of(link.block_b).young);
  return link.axial_stiffness > stiffest_in_rock * rock;
}

void remark_on_stiffness(const Model& model, const Bolt& bolt, Remarks& remarks) {
  const auto [soft, stiff] = std::ranges::minmax(bolt.links, {}, &BoltLink::axial_stiffness);
  if (soft.axial_stiffness * bolt.spacing < softest)
    remarks.push_back(
        fmt::format("bolt \"{}\" has an axial stiffness of {:.3g} N/m, softer than rubber; bolts of steel "
                    "have 1e6 to 1e9 N/m",
                    bolt.name, soft.axial_stiffness * bolt.spacing));
  if (is_stiffer_than_rock(model, stiff))
    remarks.push_back(
        fmt::format("bolt \"{}\" has an axial stiffness of {:.3g} N/m, more than the blocks that it "
                    "holds; bolts of steel have 1e6 to 1e9 N/m",
                    bolt.name, stiff.axial_stiffness * bolt.spacing));
}

void remark_on_forces(const Bolt& bolt, Remarks& remarks) {
  if (bolt.pretension * bolt.spacing > most_pretension)
    remarks.push_back(fmt::format(
        "bolt \"{}\" has a pretension of {:.3g} N; bolts have 1e4 to 1e6 N, the largest anchors of dams 1e7 N",
        bolt.name, bolt.pretension * bolt.spacing));
  if (bolt.yield_force * bolt.spacing >= weakest) return;
  remarks.push_back(
      fmt::format("bolt \"{}\" yields at {:.3g} N, which a hand can pull; bolts of steel bear 5e4 N and more",
                  bolt.name, bolt.yield_force * bolt.spacing));
}

}  // namespace

std::vector<std::string> bolt_remarks(const Model& model) {
  Remarks remarks;
  for (const Bolt& bolt : model.bolts) {
    remark_on_stiffness(model, bolt, remarks);
    remark_on_forces(bolt, remarks);
  }
  return remarks;
}

}  // namespace dda
