// For tests of explicit steps: random bonded scenes, and their modes by dense algebra.
#pragma once

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "engine/contact/make_contacts.h"
#include "engine/linear/dense_modes.h"
#include "engine/simulation/linear_operators.h"
#include "engine/simulation/simulation_models.h"
#include "engine/simulation/stability_limit.h"

namespace dda::explicit_models {

inline Stage explicit_stage(double dt, int steps) { return stage_of(central_difference_integrator(), dt, steps); }

inline Eigen::VectorXd flat_copy(const std::vector<Vec6>& values) {
  Eigen::VectorXd all(static_cast<Eigen::Index>(6 * values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) all.segment<6>(static_cast<Eigen::Index>(6 * i)) = values[i];
  return all;
}

inline Eigen::VectorXd displacements(const Simulation& simulation) {
  return flat_copy(simulation.state().displacement);
}

inline Eigen::MatrixXd dense(const BlockMatrix& matrix) {
  Eigen::MatrixXd whole(matrix.unknowns(), matrix.unknowns());
  Eigen::VectorXd column(matrix.unknowns());
  for (Eigen::Index i = 0; i < whole.cols(); ++i) {
    matrix.multiply(Eigen::VectorXd::Unit(whole.cols(), i), column);
    whole.col(i) = column;
  }
  return whole;
}

// Returns the modes of the first stage.
inline DenseModes modes_of(const Model& model) {
  const ContactSet contacts = make_contacts(model);
  const LinearOperators operators(model, make_block_terms(model, model.stages[0]), contacts,
                                  make_supports(model, initial_state(model)),
                                  WaveCorrections(model, model.stages[0], contacts));
  return dense_modes(dense(operators.stiffness.matrix()), dense(operators.inertia.matrix()));
}

// Bonded rectangles of random sizes in a row, a grid or a running bond, with loads at least; `with_all`: gravity,
// viscous edges, supports that stand and move, held blocks that move, and motion and stress at the start, each in some
// scenes.
class RandomBondedScene {
 public:
  RandomBondedScene(std::mt19937& random, bool with_all) {
    const auto chance = [&](double share) { return std::bernoulli_distribution(share)(random); };
    const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    const int columns = std::uniform_int_distribution(2, 5)(random);
    const int rows = chance(0.3) ? 1 : std::uniform_int_distribution(2, 4)(random);
    const bool equal = chance(0.5);
    model_.materials = {rock()};
    JointMaterial joint;
    joint.bonded = true;
    joint.law = rows == 1 && equal ? InterfaceLaw::cubic
                : chance(0.8)      ? InterfaceLaw::consistent
                                   : InterfaceLaw::classical;
    model_.joints = {joint};
    std::vector<double> x{0}, y{0};
    for (int i = 0; i < columns; ++i) x.push_back(x.back() + (equal ? 1.0 : number(0.5, 1.5)));
    for (int i = 0; i < rows; ++i) y.push_back(y.back() + (equal ? 0.8 : number(0.5, 1.5)));
    for (int row = 0; row < rows; ++row) add_row(x, y, row, equal || chance(0.5) ? 0 : number(-0.2, 0.2));
    const Vec2 foot(x[0], y[0]), head(x[0], y[1]);
    model_.edge_loads = {{0, head, foot, {number(-3e5, 3e5), number(-1e5, 1e5)}, SineCycles{number(20, 60), 1.5, 0}}};
    if (with_all) add_more(x, y, columns, random);
    stable_dt_ = stability_limit(finished(explicit_stage(1e-9, 1)), 0);
  }

  [[nodiscard]] double stable_dt() const { return stable_dt_; }
  [[nodiscard]] Model with(const Stage& stage) const { return finished(stage); }

  [[nodiscard]] static Stage random_stage(std::mt19937& random, double dt, int steps) {
    Stage stage = explicit_stage(dt, steps);
    const auto chance = [&] { return std::bernoulli_distribution(0.3)(random); };
    if (chance()) stage.correct_block_dispersion = true;
    if (chance()) stage.correct_time_dispersion = true;
    if (chance()) stage.velocity_factor = 0.99;
    if (chance()) stage.damping_rate = 5;
    if (chance()) stage.material_damping.mass = 20;
    if (chance()) stage.strain_inertia = 1.5;
    return stage;
  }

 private:
  void add_row(const std::vector<double>& x, const std::vector<double>& y, int row, double shift) {
    const auto r = static_cast<std::size_t>(row);
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
      const double left = i == 0 ? x[0] : x[i] + shift;
      const double right = i + 2 == x.size() ? x.back() : x[i + 1] + shift;
      model_.blocks.emplace_back().shape.outer = box_ring(left, y[r], right, y[r + 1]);
    }
  }

  void add_more(const std::vector<double>& x, const std::vector<double>& y, int columns, std::mt19937& random) {
    const auto chance = [&](double share) { return std::bernoulli_distribution(share)(random); };
    const int end = columns - 1;
    const Vec2 low(x.back(), y[0]), high(x.back(), y[1]);
    if (chance(0.4)) model_.gravity = {2, -9.81};
    if (chance(0.4)) {
      model_.viscous_edges = {{end, low, high, 1.6e6, 1e6}};
    } else if (chance(0.5)) {
      model_.supports = {{end, low, true, true, 2e8, {1e-4, 2e-4}, SineCycles{80, 2, 1e-3}},
                         {end, high, true, false, 1e8, Vec2::Zero(), {}}};
    } else if (chance(0.5) && model_.joints[0].law != InterfaceLaw::cubic) {
      model_.held_blocks.push_back({end, {1e-4, -5e-5}, 0, Vec2::Zero(), SineCycles{50, 2, 1e-3}});
    }
    if (chance(0.4)) model_.blocks[0].initial_velocity = {0.2, -0.1};
    if (chance(0.4))
      for (Block& block : model_.blocks) block.initial_stress = {-2e5, -1e5, 3e4};
  }

  [[nodiscard]] Model finished(const Stage& stage) const {
    Model model = model_;
    model.stages = {stage};
    finish_model(model);
    return model;
  }

  Model model_;
  double stable_dt_ = 0;
};

// Lets the model begin with these velocities, 6 a block.
inline void set_in_motion(const Eigen::VectorXd& velocity, Model& model) {
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Vec6 own = velocity.segment<6>(static_cast<Eigen::Index>(6 * i));
    model.blocks[i].initial_velocity = own.head<2>();
    model.blocks[i].initial_spin = own(2);
    model.blocks[i].initial_strain_rate = own.tail<3>();
  }
}

}  // namespace dda::explicit_models
