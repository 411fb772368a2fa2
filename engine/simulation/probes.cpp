#include "engine/simulation/probes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "engine/core/error.h"
#include "engine/geometry/segment.h"
#include "engine/model/quantity_names.h"
#include "engine/simulation/block_values.h"
#include "engine/simulation/contact_statistics.h"
#include "engine/simulation/excess_shear.h"
#include "engine/simulation/run_so_far.h"

namespace dda {
namespace {

bool joins(const Interface& interface, int a, int b) {
  return (interface.block_a == a && interface.block_b == b) || (interface.block_a == b && interface.block_b == a);
}

[[noreturn]] void fail(const Measurement& measurement) {
  throw InputError("", fmt::format("measurements \"{}\": point", measurement.name),
                   fmt::format("[{}, {}]", measurement.point.x(), measurement.point.y()),
                   "a point on an edge along which two blocks touch");
}

int interface_of(const Simulation& simulation, const Measurement& measurement) {
  const std::vector<Interface>& interfaces = simulation.contacts().interfaces;
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    if (interfaces[i].length == 0 || !joins(interfaces[i], measurement.block, measurement.other_block)) continue;
    const double away = distance(Segment{interfaces[i].from, interfaces[i].to}, measurement.point);
    if (away >= least) continue;
    least = away;
    nearest = static_cast<int>(i);
  }
  if (nearest < 0 || least > simulation.model().length_tolerance) fail(measurement);
  return nearest;
}

// Blocks that nothing holds together now may touch later; a line through them must cross something that is there.
Cut cut_of(const Simulation& simulation, const Measurement& measurement) {
  const bool may_come = measurement.quantity == Quantity::contact_force && simulation.follows_contacts();
  if (!may_come && !cuts_something(simulation.system(), measurement))
    throw InputError("", fmt::format("measurements \"{}\"", measurement.name), "where no blocks touch",
                     measurement.quantity == Quantity::resultant ? "a line with touching blocks on its two sides"
                                                                 : "two sides that touch");
  return make_cut(simulation.system(), measurement);
}

// Where contacts are followed faces may come later.
void expect_faces(const Simulation& simulation, const Measurement& measurement) {
  if (simulation.follows_contacts() || has_faces(simulation.system(), measurement)) return;
  throw InputError("", fmt::format("measurements \"{}\"", measurement.name), "where no joint with a strength is",
                   "blocks that touch along a joint that is not bonded, or a friction_angle or cohesion to judge by");
}

// Interfaces move up in their list when those of removed blocks leave it.
bool is_still(const std::vector<Interface>& interfaces, int interface, const Measurement& measurement,
              double tolerance) {
  const auto i = static_cast<std::size_t>(interface);
  return i < interfaces.size() && joins(interfaces[i], measurement.block, measurement.other_block) &&
         distance(Segment{interfaces[i].from, interfaces[i].to}, measurement.point) <= tolerance;
}

Vec2 traction(const Simulation& simulation, const Measurement& measurement, int interface) {
  const ContactSet& contacts = simulation.contacts();
  const bool still = is_still(contacts.interfaces, interface, measurement, simulation.model().length_tolerance);
  const auto i = static_cast<std::size_t>(still ? interface : interface_of(simulation, measurement));
  return mean_traction(simulation.model(), contacts.interfaces[i], contacts.elements.but_for_blocks(i),
                       simulation.interface_state(i));
}

// Value of one link, or of the whole bolt: the sum of elongations, the force that is largest in magnitude.
double bolt_value(const Simulation& simulation, const Measurement& measurement) {
  const Bolt& bolt = simulation.model().bolts[static_cast<std::size_t>(measurement.bolt)];
  const BoltSet& bolts = simulation.bolts();
  const bool one = measurement.link >= 0;
  const std::size_t first = one ? static_cast<std::size_t>(measurement.link) : 0;
  const std::size_t last = one ? first + 1 : bolt.links.size();
  const bool elongation = measurement.quantity == Quantity::bolt_elongation;
  double value = 0;
  for (std::size_t link = first; link < last; ++link) {
    const Vec2& force = bolts.state(measurement.bolt, link).force;
    const double own = bolt.spacing * (measurement.quantity == Quantity::bolt_shear ? force(1) : force(0));
    if (elongation) {
      value += bolts.elongation(measurement.bolt, link);
    } else if (std::abs(own) > std::abs(value)) {
      value = own;
    }
  }
  return value;
}

double value_in(const SectionForces& forces, Quantity quantity) {
  if (quantity == Quantity::lining_thrust) return forces.thrust;
  return quantity == Quantity::lining_moment ? forces.moment() : forces.shear;
}

// Value of one element, or the one that is largest in magnitude.
double lining_value(const Simulation& simulation, const Measurement& measurement) {
  const auto lining = static_cast<std::size_t>(measurement.lining);
  const auto of = [&](std::size_t element) {
    return value_in(linings_of(simulation).forces(simulation.model(), lining, element), measurement.quantity);
  };
  if (measurement.element >= 0) return of(static_cast<std::size_t>(measurement.element));
  double value = 0;
  for (std::size_t element = 0; element < simulation.model().linings[lining].elements(); ++element)
    if (const double own = of(element); std::abs(own) > std::abs(value)) value = own;
  return value;
}

template <typename Values>
void copy(const Values& from, std::span<double> to) {
  std::copy(from.begin(), from.end(), to.begin());
}

void write_statistics(const Simulation& simulation, std::span<double> values) {
  const ContactStatistics now = count_contacts(simulation);
  copy(std::array{1.0 * now.open, 1.0 * now.sliding, 1.0 * now.sticking, static_cast<double>(now.passes),
                  now.penetration},
       values);
}

}  // namespace

Probes::Probes(const Simulation& simulation) {
  for (const Measurement& measurement : simulation.model().measurements) {
    places_.push_back(place_of(simulation, measurement));
    size_ += histories_of(measurement.quantity).size();
  }
}

Probes::Place Probes::place_of(const Simulation& simulation, const Measurement& measurement) {
  Place place;
  switch (subject_of(measurement.quantity)) {
    case Subject::joint:
      if (simulation.follows_contacts()) {
        place.edge = shared_edge(simulation.model(), measurement.block, measurement.other_block, measurement.point);
        if (!place.edge) fail(measurement);
      } else {
        place.interface = interface_of(simulation, measurement);
      }
      break;
    case Subject::contact_force:
    case Subject::resultant: place.cut = cut_of(simulation, measurement); break;
    case Subject::excess_shear: expect_faces(simulation, measurement); break;
    case Subject::block:
    case Subject::bolt:
    case Subject::lining:
    case Subject::reaction:
    case Subject::contacts: break;
  }
  return place;
}

void Probes::sample(const Simulation& simulation, std::span<double> values) const {
  const std::vector<Measurement>& measurements = simulation.model().measurements;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const std::size_t count = histories_of(measurements[i].quantity).size();
    const std::span<const double> of_parts = simulation.system().audit.forces_of_parts.mean(i);
    if (of_parts.empty())
      write(simulation, measurements[i], places_[i], values.first(count));
    else
      copy(of_parts, values);
    values = values.subspan(count);
  }
}

void Probes::write(const Simulation& simulation, const Measurement& measurement, const Place& place,
                   std::span<double> values) {
  switch (subject_of(measurement.quantity)) {
    case Subject::block: values[0] = block_value(simulation.system(), measurement); break;
    case Subject::bolt: values[0] = bolt_value(simulation, measurement); break;
    case Subject::lining: values[0] = lining_value(simulation, measurement); break;
    case Subject::joint: {
      const Vec2 mean = place.edge
                            ? traction_along(simulation.model(), simulation.state(), simulation.contacts(), *place.edge)
                            : traction(simulation, measurement, place.interface);
      values[0] = measurement.quantity == Quantity::traction_normal ? mean(0) : mean(1);
      break;
    }
    case Subject::reaction:
    case Subject::contact_force:
    case Subject::resultant: write_forces(simulation.system(), measurement, place.cut, values); break;
    case Subject::excess_shear: copy(excess_shear(simulation.system(), measurement), values); break;
    case Subject::contacts: write_statistics(simulation, values); break;
  }
}

}  // namespace dda
