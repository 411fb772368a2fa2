// All contacts that the quick passes settle.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "engine/solve/interface_trials.h"
#include "engine/solve/live_contact.h"

namespace dda {

// Lists the contacts that are not whole, and where they are.
void list_live(const InterfaceTrials& contacts, std::vector<std::size_t>& places, std::vector<LiveContact>& live);

// Notes how deep contacts are pressed, when they first change one by one; it stays for all passes from then on. (At the
// start of a step blocks may touch everywhere but for round-off, whose order is another where the scene is turned.)
void note_depths(const InterfaceTrials& contacts, std::vector<LiveContact>& live);

// The largest force, N per m of thickness, that ends would answer with these increments if they stuck and held tension:
// for where nothing has a force yet. Without it round-off would say which way those go that nothing pushes.
double largest_elastic_force(const std::vector<LiveContact>& live, const Eigen::VectorXd& increment);

}  // namespace dda
