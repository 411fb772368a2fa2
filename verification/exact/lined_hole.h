// A round hole in an elastic annulus with a thin lining bonded to its wall, in plane strain: what is let go of the
// wall's tractions before the lining is there, and what it takes of the rest. SI units, per metre of thickness; tension
// positive, thrust positive in compression. Angles from the x axis.
//
// Under a stress that is the same from all sides the answer is Lame's (1852). What differs along x and y goes as
// cos(2 angle): Navier's equations have the solutions u_r = r^m cos(2 angle), u_angle = k r^m sin(2 angle) with
// m = 1, 3, -1 and -3 and one ratio k each. The lining is a ring of the membrane and bending stiffness of a thin shell
// on the wall, with the energy E' h/2 ((w + v')/a)^2 + E' h^3/24 ((v' - w'')/a^2)^2 of each length of it, E' being
// E/(1 - nu^2). H. H. Einstein & C. W. Schwartz (1979), Simplified analysis for tunnel supports, treat the same hole in
// endless rock.
#pragma once

namespace exact {

struct LinedHole {
  double radius = 0, outer_radius = 0;          // m, of the rock
  double rock_young = 0, rock_poisson = 0;      // Pa
  double thickness = 0;                         // m
  double lining_young = 0, lining_poisson = 0;  // Pa
  double stress_xx = 0, stress_yy = 0;          // Pa, in the rock before; its tractions go on outside
  double let_go = 0;                            // share of the wall's tractions that is gone when the lining comes
};

// Thrust and moment are constant parts and factors of cos(2 angle). A moment is positive that pulls the free face.
struct RingForces {
  double thrust_0 = 0, thrust_2 = 0;  // N
  double moment_2 = 0;                // N m
};

// When all of the wall's tractions are gone.
[[nodiscard]] RingForces lining_forces(const LinedHole& hole);

// How far the wall goes inwards, m, on the mean, for each Pa of pressure that is let go.
[[nodiscard]] double wall_compliance(const LinedHole& hole);

// Thrust under equal stresses from all sides (that of stress_xx) of a ring of the full thickness inside of the wall:
// Lame for both. The thin ring tends to it with the thickness over the radius.
[[nodiscard]] double thick_ring_thrust(const LinedHole& hole);

// A ring that crushes at the thrust `crushing` (N), under equal stresses from all sides: how far the wall goes inwards
// after the ring has come, and what the ring dissipates (J).
struct CrushedRing {
  double convergence = 0;  // m
  double dissipated = 0;   // J
};
[[nodiscard]] CrushedRing crushed_ring(const LinedHole& hole, double crushing);

}  // namespace exact
