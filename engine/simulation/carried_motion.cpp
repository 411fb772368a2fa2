#include "engine/simulation/carried_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "engine/core/disjoint_sets.h"
#include "engine/geometry/rotation.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// What takes a held block from where it is to the end of the step.
struct RigidMotion {
  Vec2 centroid = Vec2::Zero();  // m, at the start
  Vec2 way = Vec2::Zero();       // m, of the centroid
  double turn = 0;               // rad

  [[nodiscard]] Vec2 way_of(const Vec2& point) const {
    const Vec2 arm = point - centroid;
    return way + rotation(turn) * arm - arm;
  }

  [[nodiscard]] bool is(const RigidMotion& other) const {
    constexpr double round_off = 1e-9;
    const double size = way.norm() + other.way.norm();
    return std::abs(turn - other.turn) <= round_off * std::abs(turn) &&
           (way_of(other.centroid) - other.way).norm() <= round_off * size;
  }
};

bool is_closed(const InterfaceElement& element, const InterfaceState& state) {
  const auto ends = static_cast<std::ptrdiff_t>(ends_of(element));
  return std::any_of(state.status.begin(), state.status.begin() + ends,
                     [](ContactStatus status) { return status != ContactStatus::open; });
}

// Pairs of blocks that hold on to each other.
std::vector<std::pair<int, int>> ties_of(const BlockSystem& s) {
  std::vector<std::pair<int, int>> ties = s.reinforcement.pairs();
  for (std::size_t i = 0; i < s.contacts.elements.size(); ++i) {
    const InterfaceElement& element = s.contacts.elements.own()[i];
    if (is_closed(element, s.contacts.states[i])) ties.emplace_back(element.block_a, element.block_b);
  }
  return ties;
}

// What carries islands of blocks, which hang together without the held ones.
class Carriers {
 public:
  explicit Carriers(const BlockSystem& s) : system_(s), islands_(s.model.blocks.size()), all_(s.model.blocks.size()) {
    const std::vector<std::pair<int, int>> ties = ties_of(s);
    for (const auto& [a, b] : ties)
      if (!s.held.holds(a) && !s.held.holds(b)) islands_.join(a, b);
    for (const auto& [a, b] : ties) {
      if (s.held.holds(a) == s.held.holds(b)) continue;
      const auto [held, free] = s.held.holds(a) ? std::pair(a, b) : std::pair(b, a);
      all_[at(islands_.root(free))].add(motion_of(held));
    }
    for (const SupportElement& support : s.supports)
      if (!support.stiffness.isZero(0)) all_[at(islands_.root(support.block))].add(RigidMotion());
  }

  // Increments of its unknowns that take the block along.
  [[nodiscard]] Vec6 increments_of(int block) {
    Vec6 increments = Vec6::Zero();
    const RigidMotion motion = system_.held.holds(block) ? motion_of(block) : all_[at(islands_.root(block))].motion();
    increments.head<2>() = motion.way_of(centroid_of(block));
    increments(2) = motion.turn;
    return increments;
  }

 private:
  class Carrier {
   public:
    void add(const RigidMotion& motion) {
      if (!has_any_) motion_ = motion;
      is_one_ = is_one_ && motion_.is(motion);
      has_any_ = true;
    }
    [[nodiscard]] RigidMotion motion() const { return is_one_ ? motion_ : RigidMotion(); }

   private:
    RigidMotion motion_;
    bool has_any_ = false, is_one_ = true;
  };

  [[nodiscard]] Vec2 centroid_of(int block) const { return local_centroid(system_.model, system_.state, block); }

  [[nodiscard]] RigidMotion motion_of(int held) const {
    const Vec6& increments = system_.held.increments[at(system_.held.place[at(held)])];
    return {centroid_of(held), increments.head<2>(), increments(2)};
  }

  const BlockSystem& system_;
  DisjointSets islands_;
  std::vector<Carrier> all_;  // by the first block of an island
};

}  // namespace

bool takes_blocks_along(const BlockSystem& system) {
  if (!system.plan.is_static || !system.plan.finite_kinematics) return false;
  return std::ranges::any_of(system.held.increments, [](const Vec6& increments) { return !increments.isZero(0); });
}

void carry_along(BlockSystem& system) {
  Carriers carriers(system);
  for (std::size_t i = 0; i < system.state.velocity.size(); ++i) {
    const Vec6 increments = carriers.increments_of(static_cast<int>(i));
    system.state.velocity[i] = increments / system.coefficients.dt;
    system.increment.segment<6>(static_cast<Eigen::Index>(6 * i)) = increments;
  }
}

Eigen::VectorXd own_increments(const BlockSystem& system) {
  Eigen::VectorXd own = system.increment;
  for (std::size_t i = 0; i < system.state.velocity.size(); ++i)
    own.segment<6>(static_cast<Eigen::Index>(6 * i)) -= system.coefficients.dt * system.state.velocity[i];
  return own;
}

void put_down(BlockSystem& system) {
  for (Vec6& velocity : system.state.velocity) velocity.setZero();
}

}  // namespace dda
