// The parts of finish_model. Each throws InputError (without a file) for the first thing wrong.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/checks.h"
#include "engine/model/model.h"

namespace dda::model_checks {

void check_materials(const std::vector<Material>& materials);
void check_strengths(const std::vector<JointMaterial>& joints);
void check_joints(const Model& model);    // where they are, too
void check_blocks(const Model& model);    // their shapes must be normalized
void check_overlaps(const Model& model);  // needs length_tolerance
void check_initial_state(const Model& model);
void check_loads(const Model& model);  // needs length_tolerance, as the following ones
void check_supports(const Model& model);
void check_viscous_edges(const Model& model);
void check_held_blocks(const Model& model);
void check_free_field_side(const Model& model, std::size_t index);  // after all that acts on blocks
void check_free_field_sides(const Model& model);
void check_bolts(const Model& model);
void check_withdrawal(const Item& item, const Withdrawal& withdrawal, int first_stage, const Model& model);
void check_linings(const Model& model);
void check_measurements(const Model& model);
void check_stages(const Model& model);
void check_peaks(const Model& model);             // after the stages
void check_projected_joints(const Model& model);  // after the stages
void check_removals(const Model& model);          // after all that acts on blocks, and the stages
void check_rock_changes(const Model& model);      // after the joints and the stages

// By how much the moduli of a material may grow and fall in a run, as shares of those at the start.
struct ModulusLimits {
  double least = 0, most = 0;
  double penalty = 0;  // of the joints, in moduli; 0: none, and no limit to what may grow
};
ModulusLimits modulus_limits(const Model& model);
double modulus_growth(const Material& start, const Material& now);
// Says what is wrong with a growth, and what was expected; nothing where it is within the limits.
std::optional<std::pair<std::string, std::string>> problem_of_growth(const ModulusLimits& limits, double growth);

}  // namespace dda::model_checks
