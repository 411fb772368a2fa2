// The rock bolts of a scene: their links between steps. In the course of a step BoltTrials (engine/solve) has them.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "engine/core/types.h"
#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/simulation/energy_audit.h"
#include "engine/solve/bolt_trials.h"

namespace dda {

class BoltSet {
 public:
  BoltSet(const Model& model, const State& state);

  [[nodiscard]] bool empty() const { return links_.empty(); }
  // Blocks that links of bolts that have been put in couple.
  [[nodiscard]] std::vector<std::pair<int, int>> pairs() const;
  [[nodiscard]] double stored_energy() const;  // J per m of thickness

  // State of a link; elongation since it was put in, elastic and plastic, m; 0 before.
  [[nodiscard]] const LinkState& state(int bolt, std::size_t link) const { return links_[index(bolt, link)].state; }
  [[nodiscard]] double elongation(int bolt, std::size_t link) const {
    const LinkElement& element = links_[index(bolt, link)];
    return element.state.waits ? 0 : element.elongation(element.state.gap);
  }
  // All links, those of one bolt after those of the other.
  [[nodiscard]] std::span<const LinkElement> links() const { return links_; }

  // Turns the lines of action with blocks and anchors to where these are in `acting`, and measures elongations anew
  // (finite kinematics).
  void update_geometry(const Model& model, const State& state, const State& acting);

  // Puts in the bolts of a stage that begins, with their pretension, where the blocks are, and adds what they exert to
  // `force`. `acting`: as above; in small kinematics the drawing.
  void put_in_those_of(std::size_t stage, const Model& model, const State& state, const State& acting,
                       Eigen::VectorXd& force);

  // Takes out a bolt and adds what it exerted until now, as internal forces, to `exerted`.
  void take_out(std::size_t bolt, const Model& model, Eigen::VectorXd& exerted);

  // Bolts that the model `before_model` has as well go on as they are in `before`, with the strengths they have now;
  // the others are put in where the blocks are. What is put in from the stage `next` on waits, whatever it did before.
  void go_on_from(const Model& before_model, const BoltSet& before, const Model& model, std::size_t next,
                  const State& state, const State& acting);

  // Adds the internal forces of the states.
  void add_force(Eigen::VectorXd& force) const;

  // The trials become the state; books what yielded and broke.
  void accept(const BoltTrials& trials, EnergyAudit& audit);

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [links, first_link] = self;
    archive.same_size(links, "links of bolts");
    for (auto& link : links) archive(link);
  }

 private:
  [[nodiscard]] std::size_t index(int bolt, std::size_t link) const {
    return first_link_[static_cast<std::size_t>(bolt)] + link;
  }

  std::vector<LinkElement> links_;
  std::vector<std::size_t> first_link_;  // of each bolt
};

}  // namespace dda
