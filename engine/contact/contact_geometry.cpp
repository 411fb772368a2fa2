#include "engine/contact/contact_geometry.h"

#include <cstddef>

#include "engine/contact/interface_frame.h"
#include "engine/contact/make_element.h"
#include "engine/contact/projected_stretch.h"
#include "engine/contact/tied_sides.h"

namespace dda {

void measure_gap(const Model& model, const State& state, const Interface& interface, const InterfaceElement& element,
                 InterfaceState& own) {
  if (element.law != InterfaceLaw::consistent && element.law != InterfaceLaw::projected) return;
  const EndsApart ends = ends_apart(model, state, interface);
  if (element.law == InterfaceLaw::projected) return measure_projected(model, state, interface, element, ends, own);
  own.gap << (ends.from + ends.to) / 2, (ends.to - ends.from) / 2;
  own.gap -= element.gap_at_start;
}

void update_geometry(const Model& model, const State& state, const State& acting, ContactSet& contacts) {
  std::vector<InterfaceElement>& elements = contacts.elements.edit();
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    InterfaceElement& element = elements[i];
    set_geometry(model, acting_frame(model, acting, contacts.interfaces[i], element.law), element);
    measure_gap(model, state, contacts.interfaces[i], element, contacts.states[i]);
  }
  if (!contacts.outline_compliance.empty()) take_off_blocks(model, contacts);
}

void keep_gaps(const Model& model, const State& state, ContactSet& contacts) {
  std::vector<InterfaceElement>& elements = contacts.elements.edit();
  for (std::size_t i = 0; i < elements.size(); ++i) {
    InterfaceElement& element = elements[i];
    InterfaceState& own = contacts.states[i];
    if (element.law != InterfaceLaw::projected) continue;
    set_geometry(model, acting_frame(model, state, contacts.interfaces[i], element.law), element);
    const Vec4 more = gap_as_it_lies(model, state, contacts.interfaces[i], element, own) - own.gap;
    for (const std::size_t end : {0U, 1U}) {
      own.seat[end] += more(static_cast<Eigen::Index>(2 * end));
      own.slip[end] += more(static_cast<Eigen::Index>(2 * end) + 1);
    }
  }
}

}  // namespace dda
