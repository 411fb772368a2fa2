#include "verification/harness/cavity.h"

#include "engine/builder/free_outline.h"

namespace verify {

void press_wall(dda::Model& model, double pressure, const dda::TimeFunction& history) {
  for (const dda::Stretch& s : dda::ring_around(dda::free_rings(model), {0, 0}))
    model.edge_loads.push_back({s.block, s.from, s.to, pressure * s.inward, history});
}

void absorb_outside(dda::Model& model) {
  const dda::Material& rock = model.materials.front();
  for (const dda::Stretch& s : dda::outer_rings(dda::free_rings(model)))
    model.viscous_edges.push_back(
        {s.block, s.from, s.to, rock.density * dda::p_wave_speed(rock), rock.density * dda::s_wave_speed(rock)});
}

}  // namespace verify
