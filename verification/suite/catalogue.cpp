#include "verification/suite/catalogue.h"

namespace verify {

const std::vector<CatalogueProblem>& catalogue() {
  static const std::vector<CatalogueProblem> problems = {
      {1, "Free fall"},
      {2, "Fall with velocities cut every step"},
      {3, "Free spin"},
      {4, "Contact oscillator"},
      {5, "Elastic bounce"},
      {6, "Newton's cradle"},
      {7, "Inelastic collision"},
      {8, "Energy audit"},
      {9, "Block on an incline"},
      {10, "Block on an incline under base shaking"},
      {11, "Block on a moving base"},
      {12, "Sliding to rest"},
      {13, "Driven stick-slip"},
      {14, "Free rocking"},
      {15, "Rocking impact"},
      {16, "Uplift"},
      {17, "Toppling or sliding on an incline"},
      {18, "Toppling slope of Goodman and Bray"},
      {19, "Plane failure"},
      {20, "Roof prism"},
      {21, "Semicircular arch"},
      {22, "Laminated voussoir roof"},
      {23, "Cohesion and tension"},
      {24, "Uniaxial compression"},
      {25, "Stiffness of a stack"},
      {26, "Column under its own weight"},
      {27, "Cantilever"},
      {28, "Circular opening in a biaxial field (Kirsch)"},
      {29, "Thick-walled ring (Lame)"},
      {30, "Free square in Lame's mode"},
      {31, "Excavation that leaves the tractions"},
      {32, "P wave along a bar"},
      {33, "S wave along a bar"},
      {34, "Ends of a bar"},
      {35, "Oblique incidence on a viscous boundary"},
      {36, "Linear joint"},
      {37, "Parallel joints"},
      {38, "Joint that slips under a harmonic S wave"},
      {39, "Soil column"},
      {40, "Cylindrical cavity under a pressure pulse"},
      {41, "Sudden circular excavation"},
      {42, "Speed of plane waves against direction"},
      {43, "Lining of a round tunnel"},
  };
  return problems;
}

const std::vector<Area>& areas() {
  static const std::vector<Area> all = {
      {"Free motion, impact, energy", 1, 8},
      {"Friction and shaking", 9, 13},
      {"Rocking and toppling", 14, 17},
      {"Slopes, roofs, arches, joints", 18, 23},
      {"Stress and stiffness", 24, 31},
      {"Waves, boundaries, blasts", 32, 42},
      {"Supports", 43, 43},
  };
  return all;
}

}  // namespace verify
