// Work that nobody asked for, done beside a simulation: what the gate on instruction counts must see.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/contact/moving_contacts.h"
#include "engine/linear/block_matrix.h"
#include "engine/linear/solver.h"
#include "engine/simulation/simulation.h"

namespace dda::benchmarks {

enum class Plant {
  residuals,      // ten more sums of what the balance leaves, in every pass of the open-close iteration
  search,         // one more search for contacts, in every step
  factorization,  // one more factor of the step matrix, in every step
};

inline constexpr std::string_view plant_names = "residuals search factorization";
std::optional<Plant> plant_named(std::string_view name);

class PlantedWork {
 public:
  // The contacts of the scene must be able to move.
  PlantedWork(Plant plant, const Simulation& simulation);

  void after_step(const Simulation& simulation);

 private:
  void sum_forces(const ContactSet& contacts);

  Plant plant_;
  std::int64_t passes_ = 0;
  ContactSet contacts_;
  MovingContacts moving_;
  BlockMatrix matrix_;
  std::unique_ptr<LinearSolver> solver_;
  Eigen::VectorXd vector_, residual_;
};

}  // namespace dda::benchmarks
