// Where a run has a body, block 0, closed against its neighbours, read from the run's own contacts. Strength is read
// from the model, not from what the run makes of it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/app/coulomb_forces_test_support.h"
#include "engine/contact/contact_set.h"
#include "engine/contact/no_tension_bed.h"
#include "engine/model/state.h"
#include "engine/simulation/simulation.h"

namespace dda {

struct Touched {
  TouchingEnd end;    // `at` from the body's centroid, as they lie
  int neighbour = 0;  // number in the rock
  int stuck = 0;      // steps at whose end it was stuck
  int gripped = 0;    // steps at whose end it was stuck, or slid with its cohesion, and that were not cut
};

// m: ends that are open by less flutter, and may be closed within a step. Springs give way by a tenth of that, and what
// opens otherwise is open by more after a step.
inline constexpr double flutter = 1e-9;

class ClosedPlaces {
 public:
  ClosedPlaces(const Simulation& simulation, std::size_t contact)
      : simulation_(simulation),
        contact_(contact),
        interface_(simulation.contacts().interfaces[contact]),
        state_(simulation.contacts().states[contact]) {
    // Gaps are those of two points at the share `lever` of the ends' distance from the middle.
    const double middle = (state_.gap[0] + state_.gap[2]) / 2;
    const double half = (state_.gap[2] - state_.gap[0]) / 2 / simulation.contacts().elements[contact].lever;
    gaps_ = is_stretch() ? std::array{middle - half, middle + half} : std::array{state_.gap[0], 0.0};
  }

  std::vector<Touched> all() {
    for (std::size_t end = 0; end < (is_stretch() ? 2U : 1U); ++end) {
      const bool is_closed = state_.status[end] != ContactStatus::open;
      if (!is_closed && gaps_[end] > flutter) continue;
      const bool is_stuck = state_.status[end] == ContactStatus::locked;
      const bool grips = is_stuck || (is_closed && shear() >= ends_that_count() * cohesion());
      add(ends_[end], cohesion(), is_stuck, grips);
      if (is_closed && gapes()) add(end_of_closed_part(end), cohesion(), is_stuck, grips);
    }
    return places_;
  }

 private:
  [[nodiscard]] bool is_stretch() const { return interface_.length > 0; }
  [[nodiscard]] const JointMaterial& joint() const {
    return simulation_.model().joints[static_cast<std::size_t>(interface_.joint)];
  }

  // A stretch of which one end gapes.
  [[nodiscard]] bool gapes() const {
    return is_stretch() && (state_.status[0] == ContactStatus::open) != (state_.status[1] == ContactStatus::open);
  }

  // N per m of thickness, of a corner, or of either end of what is closed of a stretch: half of what that has. Where it
  // acts between them is the same to the body.
  [[nodiscard]] double cohesion() const {
    const double lever = simulation_.contacts().elements[contact_].lever;
    // A corner that a stretch has left knows what was closed of it then.
    const double closed = is_stretch() ? closed_share(lever, {state_.force[0], state_.force[2]}) : 1 - state_.torn[0];
    return joint().residual_cohesion * interface_.share * closed;
  }
  [[nodiscard]] double ends_that_count() const { return is_stretch() ? 2 : 1; }

  // N per m of thickness, of the contact as a whole.
  [[nodiscard]] double shear() const { return std::abs(state_.force[1] + (is_stretch() ? state_.force[3] : 0)); }

  // A stretch presses as far as its gap comes to nothing.
  [[nodiscard]] Vec2 end_of_closed_part(std::size_t end) const {
    const double rise = gaps_[1 - end] - gaps_[end];
    const double part = rise > 0 ? std::clamp(-gaps_[end] / rise, 0.0, 1.0) : 0.0;
    return ends_[end] + part * (ends_[1 - end] - ends_[end]);
  }

  void add(const Vec2& at, double cohesion, bool is_stuck, bool grips) {
    const int block = is_stretch() ? 0 : interface_.block_b;  // a contact in a point is a corner of block b
    const Model& model = simulation_.model();
    const Vec2 place = current_position(model, simulation_.state(), block, at);
    const Vec2 arm = place - current_centroid(model, simulation_.state(), 0);
    const Vec2 outward = interface_.block_a == 0 ? interface_.normal : Vec2(-interface_.normal);
    const TouchingEnd touching{arm, outward, std::tan(joint().friction_angle), cohesion};
    places_.push_back({touching, interface_.block_a + interface_.block_b, is_stuck, grips});
  }

  const Simulation& simulation_;
  std::size_t contact_;
  const Interface& interface_;
  const InterfaceState& state_;
  std::array<Vec2, 2> ends_{interface_.from, interface_.to};
  std::array<double, 2> gaps_{};
  std::vector<Touched> places_;
};

// Places nearer than `tolerance` (m), with normals within a tenth of a radian, are one: contacts of a stretch become
// those of its corners when it has slid.
inline bool is_same_place(const TouchingEnd& a, const TouchingEnd& b, double tolerance) {
  return (a.at - b.at).norm() < tolerance && (a.outward - b.outward).norm() < 0.1;
}

inline Touched& found_or_added(const Touched& place, double tolerance, std::vector<Touched>& touched) {
  const auto found = std::ranges::find_if(touched, [&](const Touched& one) {
    return one.neighbour == place.neighbour && is_same_place(one.end, place.end, tolerance);
  });
  if (found != touched.end()) return *found;
  touched.push_back(place);
  touched.back().stuck = touched.back().gripped = 0;
  return touched.back();
}

// What is closed of one contact. Ends of a closed part that is next to nothing are one place, with what both have.
inline std::vector<Touched> closed_places(const Simulation& simulation, std::size_t contact, double tolerance) {
  std::vector<Touched> places = ClosedPlaces(simulation, contact).all();
  if (places.size() < 2 || !is_same_place(places[0].end, places[1].end, tolerance)) return places;
  places[0].end.cohesion_force += places[1].end.cohesion_force;
  places.pop_back();
  return places;
}

// Adds what is closed after a step, each place once; `numbers` are those of the run's blocks in the rock. What ends did
// within a step that was cut is not known.
inline void note_contacts(const Simulation& simulation, const std::vector<int>& numbers, double tolerance, bool was_cut,
                          std::vector<Touched>& touched) {
  std::vector<Touched> now;
  for (std::size_t i = 0; i < simulation.contacts().interfaces.size(); ++i) {
    const Interface& interface = simulation.contacts().interfaces[i];
    if (interface.block_a != 0 && interface.block_b != 0) continue;
    for (Touched place : closed_places(simulation, i, tolerance)) {
      place.neighbour = numbers[static_cast<std::size_t>(place.neighbour)];
      Touched& noted = found_or_added(place, tolerance, now);
      noted.stuck = std::max(noted.stuck, place.stuck);
      noted.gripped = std::max(noted.gripped, was_cut ? 0 : place.gripped);
    }
  }
  for (const Touched& place : now) {
    Touched& noted = found_or_added(place, tolerance, touched);
    noted.stuck += place.stuck;
    noted.gripped += place.gripped;
  }
}

}  // namespace dda
