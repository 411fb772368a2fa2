// What summary.json says of the ends of stages: blocks without equilibrium, excess shear of joints, and the rates at
// which excavation released energy.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/simulation/simulation.h"

namespace dda {

// A list of blocks with stage, name, number, place (m), mass (kg per m of thickness) and the faces that hold them.
nlohmann::ordered_json unbalanced_json(const std::vector<UnbalancedBlock>& blocks, const Model& model);

// The same for people: a line for each of the first blocks, and how many more there are; empty without any.
std::string unbalanced_lines(const Simulation& simulation);

// One sentence where static stages with steps of their own, which were not asked for equilibrium, ended far from it;
// empty without any. Of several the worst is named.
std::string unasked_balance_remark(const Simulation& simulation);

// Lists by stage and joint the largest excess shear stress (Pa), where it is, and on what length it is above zero (m).
nlohmann::ordered_json excess_shear_json(const Simulation& simulation);

// Lists the stages that have taken blocks out and are over: energy released in each (J per m of thickness), over the
// area taken out (J/m3) and over the wall laid free (J/m2; null where there is none). Cook et al. 1966, Salamon 1984.
nlohmann::ordered_json energy_release_rates_json(const Simulation& simulation);

}  // namespace dda
