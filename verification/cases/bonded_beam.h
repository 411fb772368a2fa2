// A beam of bonded blocks between x = 0 and its length, its axis at y = 0, under the tractions of two-dimensional
// elasticity at both ends: what the cases of cantilevers share.
#pragma once

#include <vector>

#include "engine/model/model.h"
#include "verification/exact/cantilever.h"
#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] dda::Model bonded_beam(const std::vector<dda::Ring>& blocks, const dda::Material& rock);

// The mean over each edge of the shear stress (Pa) under `load` (N per m of thickness), at the free end.
void load_free_end(const exact::Cantilever& beam, double load, dda::Model& model);
// The means of shear and fibre stress at the other end, which hold the beam in equilibrium.
void load_held_end(const exact::Cantilever& beam, double load, dda::Model& model);

// Three springs that carry no force keep a beam in place whose ends are both loaded. Two corners of blocks must lie at
// x = 0, y = -+h/2.
void keep_in_place(const exact::Cantilever& beam, dda::Model& model);

// A static step whose inertia is 1e-10 of the stiffness, twice.
[[nodiscard]] dda::Stage two_static_steps();

// Work of loads that do not change, over the load (m).
[[nodiscard]] double working_deflection(dda::Model model, double load, Outcome& outcome);

}  // namespace verify
