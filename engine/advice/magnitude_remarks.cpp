#include "engine/advice/magnitude_remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/advice/block_named.h"
#include "engine/core/principal_stress.h"
#include "engine/model/extent.h"

namespace dda {
namespace {

using Remarks = std::vector<std::string>;

// Bounds between what occurs and what is most likely a mistake.
constexpr double softest = 1e5;           // Pa: a tenth of the softest soils
constexpr double stiffest = 1e14;         // Pa: a hundred times diamond, and what stands for rigid
constexpr double lightest = 10;           // kg/m3: below foam; 2.65 is a density in t/m3
constexpr double heaviest = 25'000;       // kg/m3: above all metals
constexpr double strongest_gravity = 50;  // m/s2: five times the Earth's
constexpr double largest_strain = 0.05;   // of in-situ stress and loads; rock breaks at a tenth of that
constexpr double least_stress = 1e3;      // Pa: 4 cm of rock
constexpr double most_for_weight = 10;    // how often less than the weight of the drawn rock that is odd
constexpr double thinnest = 100;          // Pa/m: a hundredth of water
constexpr double most_unequal = 30;       // in-situ stresses across each other; near the surface some have 5

void remark_on_gravity(const Model& model, Remarks& remarks) {
  const double gravity = model.gravity.norm();
  if (model.gravity.y() > 0)
    remarks.push_back(fmt::format("gravity points upwards, [{:g}, {:g}] m/s2: y is up, so weight has a negative y",
                                  model.gravity.x(), model.gravity.y()));
  if (gravity > strongest_gravity)
    remarks.push_back(fmt::format("gravity is {:g} m/s2, {:.3g} times the Earth's", gravity, gravity / 9.81));
}

void remark_on_tension(const Model& model, Remarks& remarks) {
  const std::vector<int> pulled =
      blocks_with(model, [](const Block& block) { return largest_principal(block.initial_stress) > 0; });
  if (pulled.empty()) return;
  const Block& first = model.blocks[static_cast<std::size_t>(pulled[0])];
  remarks.push_back(
      fmt::format("{} starts in tension, {:g} Pa: stresses are positive in tension, in-situ compression is negative",
                  blocks_named(model, pulled), largest_principal(first.initial_stress)));
}

// Blocks that start with a stress which strains them by more than rock bears.
void remark_on_strain(const Model& model, Remarks& remarks) {
  const auto strain = [&](const Block& block) {
    return -smallest_principal(block.initial_stress) / model.materials[static_cast<std::size_t>(block.material)].young;
  };
  const std::vector<int> strained = blocks_with(model, [&](const Block& b) { return strain(b) > largest_strain; });
  if (strained.empty()) return;
  const Block& first = model.blocks[static_cast<std::size_t>(strained[0])];
  remarks.push_back(fmt::format("{} starts under {:g} Pa, {:.3g} of its young: rock breaks at less than 0.01 of it",
                                blocks_named(model, strained), -smallest_principal(first.initial_stress),
                                strain(first)));
}

// A k0 in per cent. Where a block is pressed in one direction alone, as a sample is, nothing is odd.
void remark_on_unequal_stress(const Model& model, Remarks& remarks) {
  constexpr double round_off = 1e-9;
  const auto is_unequal = [](const Block& block) {
    const double most = -smallest_principal(block.initial_stress), least = -largest_principal(block.initial_stress);
    return least > round_off * most && most > most_unequal * least;
  };
  const std::vector<int> unequal = blocks_with(model, is_unequal);
  if (unequal.empty()) return;
  const Block& first = model.blocks[static_cast<std::size_t>(unequal[0])];
  remarks.push_back(fmt::format(
      "{} starts under {:.3g} Pa in one direction and {:.3g} Pa across it; in rock they differ by 5 times at most, "
      "and k0 is a share, not per cent",
      blocks_named(model, unequal), -smallest_principal(first.initial_stress),
      -largest_principal(first.initial_stress)));
}

// A stress in kPa or MPa that lost its unit: at the surface there is little of it too, but deep rock has its weight.
void remark_on_little_stress(const Model& model, Remarks& remarks) {
  double most = 0, weight = 0;
  for (const Block& block : model.blocks) {
    most = std::max(most, block.initial_stress.cwiseAbs().maxCoeff());
    weight = std::max(weight, model.materials[static_cast<std::size_t>(block.material)].density * model.gravity.norm());
  }
  if (most == 0 || most >= least_stress) return;
  const Box box = bounding_box(model);
  const double of_height = weight * (box.upper.y() - box.lower.y());
  if (of_height < most_for_weight * most) return;
  remarks.push_back(
      fmt::format("blocks start under {:.3g} Pa at most, and the weight of the rock that is drawn makes {:.2g} Pa: "
                  "without a unit stresses are in Pa, rock has some kPa or MPa",
                  most, of_height));
}

// A pressure that grows by far less in a metre than that of water.
void remark_on_gradients(const Model& model, Remarks& remarks) {
  const auto gradient = [](const EdgeLoad& load) {
    const double fall = std::abs(load.to.y() - load.from.y());
    return fall > 0 ? 2 * load.rise.norm() / fall : 0;
  };
  const auto is_thin = [&](const EdgeLoad& load) { return gradient(load) > 0 && gradient(load) < thinnest; };
  const auto first = std::ranges::find_if(model.edge_loads, is_thin);
  if (first == model.edge_loads.end()) return;
  remarks.push_back(
      fmt::format("the pressure on {} grows by {:.3g} Pa in a metre of depth; water has 9810 Pa/m: without a unit a "
                  "gradient is in Pa/m, for water write \"9.81 kPa/m\"",
                  block_named(model, first->block), gradient(*first)));
}

// A traction in Pa that was meant in another unit. Histories are factors of about one.
void remark_on_tractions(const Model& model, Remarks& remarks) {
  const auto strain = [&](const EdgeLoad& load) { return load.traction.norm() / model.material_of(load.block).young; };
  const auto largest = std::ranges::max_element(model.edge_loads, {}, strain);
  if (largest == model.edge_loads.end() || strain(*largest) <= largest_strain) return;
  remarks.push_back(fmt::format(
      "block \"{}\" is loaded by {:g} Pa, {:.3g} of its young: rock breaks at less than 0.01 of it",
      model.blocks[static_cast<std::size_t>(largest->block)].name, largest->traction.norm(), strain(*largest)));
}

void remark_on_materials(const Model& model, Remarks& remarks) {
  for (const Material& material : model.materials) {
    if (material.young < softest)
      remarks.push_back(
          fmt::format("material \"{}\": young is {:g} Pa, softer than any soil (1 MPa); rock has some GPa",
                      material.name, material.young));
    if (material.young > stiffest)
      remarks.push_back(fmt::format("material \"{}\": young is {:g} Pa, stiffer than anything (diamond has 1e12 Pa)",
                                    material.name, material.young));
    if (material.density < lightest || material.density > heaviest)
      remarks.push_back(fmt::format("material \"{}\": density is {:g} kg/m3; rock has 2000 to 3000 kg/m3",
                                    material.name, material.density));
  }
}

}  // namespace

std::vector<std::string> magnitude_remarks(const Model& model) {
  Remarks remarks;
  for (const auto& remark : {remark_on_gravity, remark_on_tension, remark_on_strain, remark_on_unequal_stress,
                             remark_on_little_stress, remark_on_tractions, remark_on_gradients, remark_on_materials})
    remark(model, remarks);
  return remarks;
}

}  // namespace dda
