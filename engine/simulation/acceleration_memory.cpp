#include "engine/simulation/acceleration_memory.h"

#include <cstddef>
#include <numeric>

#include "engine/contact/closure.h"

namespace dda {
namespace {

void count_closed_ends(const ContactSet& contacts, std::size_t blocks, std::vector<int>& closed) {
  closed.assign(blocks, 0);
  InterfaceElement room;
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements.read(i, room);
    for (std::size_t end = 0; end < static_cast<std::size_t>(ends_of(element)); ++end) {
      if (contacts.states[i].status[end] == ContactStatus::open) continue;
      ++closed[static_cast<std::size_t>(element.block_a)];
      ++closed[static_cast<std::size_t>(element.block_b)];
    }
  }
}

double square(const Inertia& inertia, const Vec6& acceleration) {
  return acceleration.dot(momentum(inertia, acceleration));
}

}  // namespace

void AccelerationMemory::begin(const std::vector<Inertia>& inertia, const ContactSet& contacts,
                               const std::vector<Vec6>& acceleration) {
  inertia_ = inertia;
  bodies_.resize(acceleration.size());
  std::iota(bodies_.begin(), bodies_.end(), std::size_t{0});
  touched_held_.assign(acceleration.size(), 0);
  join(contacts);
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
  if (closed_ == was_closed_) return;
  join(contacts);
  note_hits();
}

// A forest of representatives; blocks stay together to the end of the step, as what they have given each other does.
std::size_t AccelerationMemory::body_of(std::size_t block) {
  while (bodies_[block] != block) block = bodies_[block] = bodies_[bodies_[block]];
  return block;
}

void AccelerationMemory::join(const ContactSet& contacts) {
  InterfaceElement room;
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements.read(i, room);
    if (is_open(element, contacts.states[i])) continue;
    const auto a = static_cast<std::size_t>(element.block_a);
    const auto b = static_cast<std::size_t>(element.block_b);
    if (inertia_[a].mass > 0 && inertia_[b].mass > 0) {
      bodies_[body_of(a)] = body_of(b);
    } else {
      touched_held_[a] = touched_held_[b] = 1;
    }
  }
}

// Where a contact has opened, an impact that was under way before the step may have ended: there all counts that has
// been given since the start of the step.
void AccelerationMemory::note_hits() {
  hits_.assign(closed_.size(), Hit::none);
  for (std::size_t i = 0; i < closed_.size(); ++i) {
    if (closed_[i] == was_closed_[i]) continue;
    Hit& hit = hits_[body_of(i)];
    if (hit != Hit::ended) hit = closed_[i] < was_closed_[i] ? Hit::ended : Hit::begun;
  }
  for (std::size_t i = 0; i < closed_.size(); ++i) {
    const Hit hit = hits_[body_of(i)];
    if (hit == Hit::none || was_hit_[i] != 0) continue;
    was_hit_[i] = 1;
    if (hit == Hit::begun) start_[i] = before_[i];
  }
}

void AccelerationMemory::shrink(double dt, std::vector<Vec6>& acceleration) {
  if (!(dt > last_dt_) || last_dt_ == 0) return;
  sum_gains(acceleration);
  shrink_gains(last_dt_ / dt, acceleration);
}

void AccelerationMemory::sum_gains(const std::vector<Vec6>& acceleration) {
  sums_.assign(acceleration.size(), {});
  for (std::size_t i = 0; i < acceleration.size(); ++i) {
    if (was_hit_[i] == 0) continue;
    Body& body = sums_[body_of(i)];
    body.mass += inertia_[i].mass;
    body.gained += square(inertia_[i], acceleration[i]) - square(inertia_[i], start_[i]);
    body.touches_held = body.touches_held || touched_held_[i] != 0;
  }
}

void AccelerationMemory::shrink_gains(double share, std::vector<Vec6>& acceleration) {
  for (std::size_t i = 0; i < acceleration.size(); ++i) {
    if (was_hit_[i] == 0 || sums_[body_of(i)].gained <= 0) continue;
    const Vec6 taken = (1 - share) * (acceleration[i] - start_[i]);
    acceleration[i] -= taken;
    sums_[body_of(i)].taken += inertia_[i].mass * taken.head<2>();
  }
  for (std::size_t i = 0; i < acceleration.size(); ++i) {
    if (was_hit_[i] == 0) continue;
    const Body& body = sums_[body_of(i)];
    if (!body.touches_held && body.mass > 0) acceleration[i].head<2>() += body.taken / body.mass;
  }
}

}  // namespace dda
