#include "engine/advice/spin_remarks.h"

#include <fmt/format.h>

#include <cstddef>
#include <set>

#include "engine/core/principal_stress.h"
#include "engine/terms/inertia.h"

namespace dda {
namespace {

constexpr double little = 1e6;  // Pa: what weak rock bears in tension

// Pa, the mean stress with which a block that spins freely is at rest in the frame that turns with it: its integral is
// that of rho omega^2 r r'.
Vec3 centrifugal_stress(const Model& model, int index) {
  const Block& block = model.blocks[static_cast<std::size_t>(index)];
  const double density = model.material_of(index).density;
  return density * block.initial_spin * block.initial_spin * mean_squares(block.moments);
}

std::set<std::size_t> blocks_that_touch(const ContactSet& contacts) {
  std::set<std::size_t> touching;
  for (const Interface& interface : contacts.interfaces) {
    touching.insert(static_cast<std::size_t>(interface.block_a));
    touching.insert(static_cast<std::size_t>(interface.block_b));
  }
  return touching;
}

}  // namespace

// Static stages take the spin away, and where geometry stays as drawn nothing turns. What blocks that touch others
// carry is not theirs alone.
std::vector<std::string> spin_remarks(const Model& model, const ContactSet& contacts) {
  const Stage& stage = model.stages.front();
  if (stage.integrator.is_static || stage.kinematics == Kinematics::small) return {};
  const std::set<std::size_t> touching = blocks_that_touch(contacts);
  std::vector<std::string> remarks;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Block& block = model.blocks[i];
    if (block.initial_spin == 0 || touching.contains(i)) continue;
    const Vec3 stress = centrifugal_stress(model, static_cast<int>(i));
    if (largest_principal(stress - block.initial_stress) < little) continue;
    const bool damps = !with_contacts(stage.integrator).conserves_contact_energy;
    remarks.push_back(fmt::format(
        "block \"{}\" spins at {:.4g} rad/s, and the centrifugal force pulls it with {:.3g} MPa on average; as it "
        "begins without that stress it vibrates about it{}",
        block.name, block.initial_spin, largest_principal(stress) / 1e6,
        damps ? "" : fmt::format(", and {} damps nothing", stage.integrator.name)));
  }
  return remarks;
}

}  // namespace dda
