#include "engine/simulation/contact_statistics.h"

#include <algorithm>
#include <cstddef>

#include "engine/contact/closure.h"
#include "engine/simulation/block_system.h"

namespace dda {
namespace {

void count(ContactStatus status, ContactStatistics& statistics) {
  switch (status) {
    case ContactStatus::open: ++statistics.open; break;
    case ContactStatus::sliding: ++statistics.sliding; break;
    case ContactStatus::locked: ++statistics.sticking; break;
  }
}

}  // namespace

ContactStatistics count_contacts(const Simulation& simulation) {
  ContactStatistics statistics;
  const BlockSystem& system = simulation.system();
  statistics.passes = system.passes_of_step();
  const ContactSet& contacts = simulation.contacts();
  InterfaceElement room;
  for (std::size_t i = 0; i < contacts.elements.size(); ++i) {
    const InterfaceElement& element = contacts.elements.read(i, room);
    const InterfaceState state = simulation.interface_state(i);
    for (int end = 0; end < ends_of(element); ++end) count(state.status[static_cast<std::size_t>(end)], statistics);
    statistics.penetration =
        std::max(statistics.penetration,
                 depth_in_each_other(system.model, system.state, contacts.interfaces[i], element, state));
  }
  return statistics;
}

}  // namespace dda
