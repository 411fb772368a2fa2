// Linings in a run: their beam elements and what these have suffered since they were sprayed; those of later stages
// wait.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "engine/linear/block_matrix.h"
#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/simulation/energy_audit.h"
#include "engine/terms/lining.h"
#include "engine/terms/lining_yield.h"

namespace dda {

// What a step takes for the answer of an element: `force` at the gap `at`, and its slope from there.
struct LiningTangent {
  bool is_elastic = true;  // then the others are not asked
  Vec3 at = Vec3::Zero(), force = Vec3::Zero();
  Mat3 slope = Mat3::Zero();
};

struct LiningElement {
  int block_a = 0, block_b = 0;
  bool can_yield = false;
  LiningStrength strength;
  Vec3 stiffness = Vec3::Zero();  // of the gaps of engine/terms/lining.h, per m of thickness out of the plane
  LiningRows rows;
  Vec3 start = Vec3::Zero();    // what the gaps were, measured from the drawing, when it was sprayed
  Vec3 gap = Vec3::Zero();      // m, rad, rad: what is elastic of their growth since then
  Vec3 plastic = Vec3::Zero();  // and what is not
  bool waits = false;           // it is sprayed at the start of a later stage
  LiningTangent tangent;        // of the step under way

  // N, M and Q: N, N m and N m per m of thickness.
  [[nodiscard]] Vec3 force() const { return stiffness.cwiseProduct(gap); }
  [[nodiscard]] bool has_yielded() const { return !plastic.isZero(0); }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [block_a, block_b, can_yield, strength, stiffness, rows, start, gap, plastic, waits, tangent] = self;
    archive(rows.a, rows.b, start, gap, plastic, waits);  // the others are the model's, or begin with every step
  }
};

// What a section carries, per m of thickness out of the plane.
struct SectionForces {
  double thrust = 0;           // N, positive in compression
  double moment_at_start = 0;  // N m, positive where it pulls the free face
  double moment_at_end = 0;
  double shear = 0;        // N, the slope of the moment along the wall with the rock on the left
  double utilisation = 0;  // of its strength; 0 where it has none to exceed

  [[nodiscard]] double moment() const { return (moment_at_start + moment_at_end) / 2; }
};

// What came of a round of Newton's method for linings, around that of the contacts.
struct LiningRound {
  bool goes_on = false;           // the answers were not those expected
  bool has_other_slopes = false;  // than the round before
};

class LiningSet {
 public:
  LiningSet() = default;
  LiningSet(const Model& model, const State& state);

  [[nodiscard]] bool empty() const { return elements_.empty(); }
  [[nodiscard]] std::span<const LiningElement> elements() const { return elements_; }
  [[nodiscard]] const LiningElement& element(std::size_t lining, std::size_t element) const {
    return elements_[first_element_[lining] + element];
  }
  [[nodiscard]] SectionForces forces(const Model& model, std::size_t lining, std::size_t element) const;

  // Blocks that linings which have been sprayed couple.
  [[nodiscard]] std::vector<std::pair<int, int>> pairs() const;
  [[nodiscard]] double stored_energy() const;  // J per m of thickness

  void add_stiffness(double factor, BlockMatrix& matrix) const;
  // Adds the internal forces.
  void add_force(Eigen::VectorXd& force) const;

  // Sprays the linings of a stage that begins, free of stress where the blocks are in `state`. `acting`: where forces
  // act; in small kinematics the drawing.
  void put_in_those_of(std::size_t stage, const Model& model, const State& state, const State& acting);

  // Takes out a lining and adds what it exerted until now, as internal forces, to `exerted`.
  void take_out(std::size_t lining, const Model& model, Eigen::VectorXd& exerted);

  // Linings that the model `before_model` has as well go on as they are in `before`; the others are sprayed where the
  // blocks are. What is sprayed from the stage `next` on waits.
  void go_on_from(const Model& before_model, const LiningSet& before, const Model& model, std::size_t next,
                  const State& state, const State& acting);

  // Turns elements with the wall to where it is in `acting`, and measures gaps anew (finite kinematics).
  void update_geometry(const Model& model, const State& state, const State& acting);

  // Follows the increments of all blocks where no element can yield.
  void advance(const Eigen::VectorXd& increment);

  // In the course of a step (Newton's method around that of the contacts): begins with elastic tangents; true where
  // some were others.
  bool begin_step();
  // Takes the tangents at what the blocks have come to in a round of that method, counted from 0.
  [[nodiscard]] LiningRound follow(const Eigen::VectorXd& increment, int round);
  // Elastic slopes need hundreds of rounds where a lining yields all around; a step that can be cut is not worth them.
  static constexpr int most_rounds = 1000;
  static constexpr int most_rounds_before_a_cut = 40;
  // Takes off what tangents expect of elements whose gaps stay, beyond their forces at the start of the step.
  void add_constant_forces(double factor, Eigen::VectorXd& rhs) const;
  // The step is over: books what yielded.
  void accept(const Eigen::VectorXd& increment, EnergyAudit& audit);

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [elements, first_element] = self;
    archive.same_size(elements, "elements of linings");
    for (auto& element : elements) archive(element);
  }

 private:
  void put_in(std::size_t lining, const Model& model, const State& state, const State& acting);

  std::vector<LiningElement> elements_;
  std::vector<std::size_t> first_element_;  // of each lining
};

}  // namespace dda
