#include "engine/simulation/acceleration_memory.h"

#include <cstddef>
#include <numeric>

namespace dda {
namespace {

// Leaves a share of what a motion's acceleration has gained; one that has faded stays as it is.
template <int Size>
void shrink_gain(double share, const Eigen::Matrix<double, Size, 1>& weights, const Vec6& before, int first,
                 Vec6& now) {
  const auto old = before.segment<Size>(first);
  auto own = now.segment<Size>(first);
  if (own.cwiseAbs2().dot(weights) > old.cwiseAbs2().dot(weights)) own = (old + share * (own - old)).eval();
}

void count_closed_ends(const ContactSet& contacts, std::size_t blocks, std::vector<int>& closed) {
  closed.assign(blocks, 0);
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements[i];
    for (std::size_t end = 0; end < static_cast<std::size_t>(ends_of(element)); ++end) {
      if (contacts.states[i].status[end] == ContactStatus::open) continue;
      ++closed[static_cast<std::size_t>(element.block_a)];
      ++closed[static_cast<std::size_t>(element.block_b)];
    }
  }
}

// Blocks that hang together by closed contacts share what an impact leaves: shrunk in some of them alone, it would be
// no longer as much one way as the other, and their momentum would change. A forest of representatives.
class Bodies {
 public:
  Bodies(const ContactSet& contacts, std::size_t blocks, std::vector<std::size_t>& parent) : parent_(parent) {
    parent_.resize(blocks);
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
      const InterfaceElement& element = contacts.elements[i];
      const auto& status = contacts.states[i].status;
      const bool is_open =
          status[0] == ContactStatus::open && (is_lone_vertex(element) || status[1] == ContactStatus::open);
      if (!is_open)
        parent_[of(static_cast<std::size_t>(element.block_a))] = of(static_cast<std::size_t>(element.block_b));
    }
  }
  std::size_t of(std::size_t block) {
    while (parent_[block] != block) block = parent_[block] = parent_[parent_[block]];
    return block;
  }

 private:
  std::vector<std::size_t>& parent_;
};

}  // namespace

void AccelerationMemory::begin(const ContactSet& contacts, const std::vector<Vec6>& acceleration) {
  count_closed_ends(contacts, acceleration.size(), closed_);
  was_hit_.assign(acceleration.size(), 0);
  start_ = acceleration;
  last_dt_ = 0;
}

void AccelerationMemory::begin_part(double dt, std::vector<Vec6>& acceleration) {
  before_ = acceleration;
  shrink(dt, acceleration);
}

void AccelerationMemory::end_part(double dt, const ContactSet& contacts) {
  last_dt_ = dt;
  closed_.swap(was_closed_);
  count_closed_ends(contacts, was_closed_.size(), closed_);
  if (closed_ != was_closed_) note_hits(contacts);
}

void AccelerationMemory::note_hits(const ContactSet& contacts) {
  Bodies bodies(contacts, closed_.size(), bodies_);
  is_hit_.assign(closed_.size(), 0);
  for (std::size_t i = 0; i < closed_.size(); ++i)
    if (closed_[i] != was_closed_[i]) is_hit_[bodies.of(i)] = 1;
  for (std::size_t i = 0; i < closed_.size(); ++i) {
    if (is_hit_[bodies.of(i)] == 0 || was_hit_[i] != 0) continue;
    was_hit_[i] = 1;
    start_[i] = before_[i];
  }
}

void AccelerationMemory::shrink(double dt, std::vector<Vec6>& acceleration) const {
  using One = Eigen::Matrix<double, 1, 1>;
  if (!(dt > last_dt_) || last_dt_ == 0) return;
  const double share = last_dt_ / dt;
  for (std::size_t i = 0; i < acceleration.size(); ++i) {
    if (was_hit_[i] == 0) continue;
    shrink_gain<2>(share, Vec2(1, 1), start_[i], 0, acceleration[i]);
    shrink_gain<1>(share, One(1), start_[i], 2, acceleration[i]);
    shrink_gain<3>(share, Vec3(1, 1, 0.5), start_[i], 3, acceleration[i]);  // a norm of strains in any direction
  }
}

}  // namespace dda
