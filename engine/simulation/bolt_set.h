// The rock bolts of a scene: state of their links, and their part in a step.
//
// Links take part in the open-close iteration as contacts do: with the same Newton steps and the same line search, but
// with bounds that do not depend on other forces. In the course of a step a link is at a trial gap; accept() makes it
// the state.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <utility>
#include <vector>

#include "engine/core/types.h"
#include "engine/linear/block_matrix.h"
#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/simulation/energy_audit.h"
#include "engine/terms/bolt.h"

namespace dda {

// A link of a bolt now: along and across it.
struct LinkState {
  Vec2 gap = Vec2::Zero();      // m, elastic, with what stands for the pretension
  Vec2 plastic = Vec2::Zero();  // m, since the start
  Vec2 force = Vec2::Zero();    // N per m of thickness; tension positive
  bool ruptured = false;
};

class BoltSet {
 public:
  BoltSet(const Model& model, const State& state);

  [[nodiscard]] bool empty() const { return links_.empty(); }
  // Blocks that links couple.
  [[nodiscard]] std::vector<std::pair<int, int>> pairs() const;
  [[nodiscard]] double stored_energy() const;  // J per m of thickness

  // State of a link; elongation since the start, elastic and plastic, m.
  [[nodiscard]] const LinkState& state(int bolt, std::size_t link) const { return links_[index(bolt, link)].state; }
  [[nodiscard]] double elongation(int bolt, std::size_t link) const { return elongation(links_[index(bolt, link)]); }

  // Turns the lines of action with blocks and anchors and measures elongations anew (finite kinematics).
  void update_geometry(const Model& model, const State& state);

  // Adds the internal forces of the states.
  void add_force(Eigen::VectorXd& force) const;

  // Adds the stiffness of the rows that were active when active_rows_changed() was last called.
  void add_stiffness(double factor, BlockMatrix& matrix) const;

  // The steps of the open-close iteration, in its words (open_close_loop.cpp). `factor` is the integrator's on
  // stiffness.
  void start_trials();
  [[nodiscard]] bool active_rows_changed();
  void add_rhs(double factor, Eigen::VectorXd& rhs) const;
  void aim(const Eigen::VectorXd& newton_step);
  [[nodiscard]] double mismatch_of_whole_step() const;
  [[nodiscard]] double largest_force() const;
  [[nodiscard]] double active_curvature() const;     // p K p of the active rows, p being the Newton step
  [[nodiscard]] double active_slope() const;         // p . (force of the active rows by what has been reached)
  [[nodiscard]] double force_along(double t) const;  // p . force after a share t of the Newton step
  void follow_trials(double share);
  [[nodiscard]] bool break_links();  // beyond their rupture elongation; true when one broke

  // The trials become the state; books what yielded and broke.
  void accept(EnergyAudit& audit);

 private:
  friend struct SnapshotAccess;  // snapshot.h

  struct Link {
    int bolt = 0, number = 0;  // in the model
    int block_a = 0, block_b = 0;
    BoltLaw law;
    double rupture_elongation = 0;
    double pretension_gap = 0;  // m
    BoltRows rows;
    LinkState state;
    // In the course of a step.
    Vec2 gap = Vec2::Zero(), direction = Vec2::Zero(), force = Vec2::Zero(), active = Vec2::Ones();
    Vec2 matrix_rows = Vec2::Constant(-1);  // active rows whose stiffness the matrix holds
    bool ruptures = false;
  };

  [[nodiscard]] std::size_t index(int bolt, std::size_t link) const {
    return first_link_[static_cast<std::size_t>(bolt)] + link;
  }
  [[nodiscard]] static double elongation(const Link& link) {
    return link.state.gap(0) + link.state.plastic(0) - link.pretension_gap;
  }
  static void respond(Link& link);
  static void place(const Model& model, const State& state, Link& link);

  std::vector<Link> links_;
  std::vector<std::size_t> first_link_;  // of each bolt
};

}  // namespace dda
