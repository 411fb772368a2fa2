#include "planted_work.h"

#include <cstdio>
#include <cstdlib>

#include "engine/contact/make_contacts.h"
#include "engine/simulation/held_blocks.h"
#include "engine/simulation/step_coefficients.h"
#include "engine/simulation/support_set.h"
#include "engine/simulation/system_matrix.h"

namespace dda::benchmarks {
namespace {

constexpr int residuals_a_pass = 10;

// The matrix of a step in which every contact carries in normal and in shear.
BlockMatrix matrix_of(const Simulation& simulation, const MovingContacts& moving, const ContactSet& contacts) {
  const Model& model = simulation.model();
  const Stage& stage = model.stages.back();
  const std::vector<Vec4> all_rows(contacts.elements.size(), Vec4::Ones());
  BlockMatrix matrix(static_cast<int>(model.blocks.size()), moving.pairs());
  assemble(step_coefficients(stage.integrator, stage.dt), make_block_terms(model), {},
           make_supports(model, simulation.state()), contacts, all_rows, matrix);
  HeldCouplings().take_out(make_held_unknowns(model), matrix);
  return matrix;
}

}  // namespace

std::optional<Plant> plant_named(std::string_view name) {
  if (name == "residuals") return Plant::residuals;
  if (name == "search") return Plant::search;
  if (name == "factorization") return Plant::factorization;
  return std::nullopt;
}

PlantedWork::PlantedWork(Plant plant, const Simulation& simulation)
    : plant_(plant),
      passes_(simulation.counters().open_close_iterations),
      contacts_(make_contacts(simulation.model())),
      moving_(simulation.model(), simulation.state(), contacts_),
      matrix_(matrix_of(simulation, moving_, contacts_)),
      solver_(make_solver(simulation.plan().solver, simulation.plan().chi.largest)),
      vector_(Eigen::VectorXd::Ones(matrix_.unknowns())),
      residual_(Eigen::VectorXd::Zero(matrix_.unknowns())) {
  solver_->analyze(matrix_);
}

void PlantedWork::sum_forces(const ContactSet& contacts) {
  matrix_.multiply(vector_, residual_);
  add_contact_force(contacts, residual_);
}

void PlantedWork::after_step(const Simulation& simulation) {
  const std::int64_t passes = simulation.counters().open_close_iterations;
  for (std::int64_t i = 0; plant_ == Plant::residuals && i < residuals_a_pass * (passes - passes_); ++i)
    sum_forces(simulation.contacts());
  passes_ = passes;
  if (plant_ == Plant::search) moving_.follow(simulation.model(), simulation.state(), contacts_);
  if (plant_ == Plant::factorization && solver_->factorize(matrix_) != Status::ok) {
    std::fprintf(stderr, "the planted factorization failed\n");
    std::abort();
  }
}

}  // namespace dda::benchmarks
