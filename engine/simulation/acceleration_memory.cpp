#include "engine/simulation/acceleration_memory.h"

#include <cstddef>

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

std::vector<int> closed_ends(const ContactSet& contacts, std::size_t blocks) {
  std::vector<int> closed(blocks, 0);
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements[i];
    for (std::size_t end = 0; end < static_cast<std::size_t>(ends_of(element)); ++end) {
      if (contacts.states[i].status[end] == ContactStatus::open) continue;
      ++closed[static_cast<std::size_t>(element.block_a)];
      ++closed[static_cast<std::size_t>(element.block_b)];
    }
  }
  return closed;
}

}  // namespace

void AccelerationMemory::begin(const ContactSet& contacts, const std::vector<Vec6>& acceleration) {
  closed_ = closed_ends(contacts, acceleration.size());
  was_hit_.assign(acceleration.size(), 0);
  start_ = acceleration;
  last_dt_ = 0;
}

void AccelerationMemory::begin_part(double dt, std::vector<Vec6>& acceleration) {
  before_ = acceleration;
  shrink(dt, acceleration);
}

void AccelerationMemory::end_part(double dt, const ContactSet& contacts) {
  std::vector<int> closed = closed_ends(contacts, closed_.size());
  for (std::size_t i = 0; i < closed.size(); ++i) {
    if (closed[i] == closed_[i] || was_hit_[i] != 0) continue;
    was_hit_[i] = 1;
    start_[i] = before_[i];
  }
  closed_.swap(closed);
  last_dt_ = dt;
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
