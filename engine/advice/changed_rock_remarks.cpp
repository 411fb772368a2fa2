#include "engine/advice/changed_rock_remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "engine/model/rock_change.h"

namespace dda {
namespace {

constexpr double softest = 1e5;  // Pa: a tenth of the softest soils, as for materials of the scene

void remark_on_soft_rock(const Stage& stage, std::vector<std::string>& remarks) {
  for (const Material& material : stage.rock.materials)
    if (material.young < softest)
      remarks.push_back(
          fmt::format("stage \"{}\": young of material \"{}\" becomes {:g} Pa, softer than any soil (1 MPa); rock has "
                      "some GPa",
                      stage.name, material.name, material.young));
}

bool has_other_waves(const Model& model, std::size_t stage) {
  const auto same = [](const Material& a, const Material& b) {
    return have_same_moduli(a, b) && have_same_density(a, b);
  };
  return !std::ranges::equal(materials_in(model, 0), materials_in(model, stage), same);
}

}  // namespace

std::vector<std::string> changed_rock_remarks(const Model& model) {
  std::vector<std::string> remarks;
  for (std::size_t i = 1; i < model.stages.size(); ++i) {
    const Stage& stage = model.stages[i];
    remark_on_soft_rock(stage, remarks);
    if (!stage.integrator.is_static && has_other_waves(model, i))
      remarks.push_back(
          fmt::format("stage \"{}\" has other moduli or densities than the scene begins with: what is foretold of "
                      "waves, and a dt that is chosen, go by those of the start",
                      stage.name));
  }
  return remarks;
}

}  // namespace dda
