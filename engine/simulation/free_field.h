// Free-field sides in a run: the columns beside them, stepped before the model they stand beside, and what they do to
// it. The columns know nothing of the model, so that what they do is a load known at the end of each step.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/contact/contact_geometry.h"
#include "engine/contact/contact_set.h"
#include "engine/contact/tied_sides.h"
#include "engine/core/status.h"
#include "engine/core/types.h"
#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/simulation/free_field_columns.h"
#include "engine/simulation/simulation.h"

namespace dda {

class FreeField {
 public:
  // `contacts` and `state` of the drawn model, which has at least one free-field side.
  FreeField(const Model& model, const ContactSet& contacts, const State& state);

  // Steps the columns to `time` (s), the end of a step of `dt` (s) of the stage, unless they are there.
  [[nodiscard]] Status advance_to(double time, double dt);
  // What is to be said where the last step failed.
  [[nodiscard]] const std::string& message() const { return columns_.message(); }

  // True when the columns have come to rest in a static stage that ends at `time`.
  [[nodiscard]] bool stands_still_until(double time) const;

  // A stage after the first. Sides that begin to act with it carry the forces that come from now on: what was there
  // before is held by what the model had in their place. False when no force of a side is another.
  bool begin_stage(const Model& model, const State& state, std::size_t stage);

  // Moves the edges with their blocks (finite kinematics).
  void update_geometry(const Model& model, const State& state, std::size_t stage);

  // Adds the forces of the sides at `time` to `force`, 6 entries a block; linear in time between the ends of the
  // columns' last step. `stiffness_damping` (s) is that of the material in the stage: the ground beyond a side resists
  // rates as the column does, with so many seconds' worth of what it carries more each second.
  void add_loads_at(double time, double stiffness_damping, Eigen::VectorXd& force) const;

  [[nodiscard]] const Simulation& columns() const { return columns_; }

  // Brings the columns, which have not stepped, to where those of a run that is over are, see branch.h.
  void go_on_from(const FreeField& before);

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [contacts, columns, time_old, time] = self;
    archive.run(columns);
    archive(time_old, time);
    for (auto& contact : contacts) archive(contact);
  }

 private:
  struct Motion {
    Vec6 velocity = Vec6::Zero();
    // N, on the right side of the block, and N m, on its strains, where the joint there is of the projected law: half
    // of what both sides do to them. And by how much the velocity changes these each second.
    Vec2 force = Vec2::Zero(), force_rate = Vec2::Zero();
    Vec3 on_strains = Vec3::Zero(), on_strains_rate = Vec3::Zero();

    template <typename Self, typename Archive>
    static void visit(Self& self, Archive& archive) {
      auto& [velocity, force, force_rate, on_strains, on_strains_rate] = self;
      archive(velocity, force, force_rate, on_strains, on_strains_rate);
    }
  };

  // Where a block of a column acts on a block of the model.
  struct Contact {
    int block = 0;                 // of the model
    int column_block = 0;          // of the columns
    std::size_t ties = 0;          // the first of the two supports that tie its sides
    Mat6 dashpots = Mat6::Zero();  // times the column's velocity
    Eigen::Matrix<double, 6, 2> middle = Eigen::Matrix<double, 6, 2>::Zero();  // of the edge, times the ties' force
    double wider = 1;                                                          // than the column's block
    bool acts = false;                                                         // from its stage on
    Vec2 force_before = Vec2::Zero();                                          // N, when the side began to act
    Vec3 on_strains_before = Vec3::Zero();                                     // N m
    Motion old, now;                                                           // at the ends of the columns' last step

    template <typename Self, typename Archive>
    static void visit(Self& self, Archive& archive) {
      auto& [block, column_block, ties, dashpots, middle, wider, acts, force_before, on_strains_before, old, now] =
          self;
      archive(dashpots, middle, acts, force_before, on_strains_before, old, now);  // the others are the drawing's
    }
  };

  FreeField(const Model& model, const State& state, FreeFieldColumns&& columns);
  void read_columns();
  void keep_pace(const std::vector<Vec6>& before, double dt);
  bool stand_still();
  [[nodiscard]] Motion motion_of(const Contact& contact) const;
  void add_on_strains(const Contact& contact, const TiedSides& sides, Motion& motion) const;
  void place(const Model& model, const State& state, const ViscousEdge& edge, double outward, Contact& contact);

  std::vector<Contact> contacts_;  // of the edges of all sides, one after the other
  Simulation columns_;
  double time_old_ = 0, time_ = 0;  // s
};

}  // namespace dda
