// The linear kinematics and stiffness of one interface, in one form for both laws.
//
// An interface sees four gaps g (block b minus block a; normal: opening positive; tangent: counter-clockwise from the
// normal), rows of g = rows_a d_a + rows_b d_b:
//   classical law:  0, 1 = normal, tangential gap at `from`;  2, 3 = the same at `to`         (Shi's corner springs)
//   consistent law: 0, 1 = the same at the middle;             2, 3 = half of (to - from)      (Nitsche at mid-edge)
// and four conjugate forces (N per m of thickness, tension positive)
//   f = stiffness * g                     classical
//   f = stiffness * g + (traction, 0)     consistent, traction = length * {sigma} n, {} the mean of both blocks.
// Both follow from the potential 1/2 g K g + g . (traction, 0), which makes the consistent law symmetric: the blocks'
// strains then carry the extra forces traction_rows^T g.
#pragma once

#include "dda/contact/interface.h"
#include "dda/core/types.h"
#include "dda/model/model.h"

namespace dda {

using Vec4 = Eigen::Vector4d;
using Mat46 = Eigen::Matrix<double, 4, 6>;
using Mat23 = Eigen::Matrix<double, 2, 3>;

struct InterfaceElement {
  int block_a = 0;
  int block_b = 0;
  InterfaceLaw law = InterfaceLaw::classical;
  double length = 0;
  Mat46 rows_a, rows_b;
  Vec4 stiffness;         // N/m per m of thickness, of each row while it is closed and stuck
  Mat23 half_traction;    // maps one block's stress to its share of the traction: 1/2 length * (normal, tangent)
  Mat23 traction_rows_a;  // half_traction * elasticity: the same from the strain increments
  Mat23 traction_rows_b;
};

// The frame of an interface: its ends as seen by each block, its normal, and where the blocks' centroids are.
struct InterfaceFrame {
  Vec2 from_a, to_a, from_b, to_b;
  Vec2 normal;
  Vec2 centroid_a, centroid_b;
};

// Frame in the reference geometry.
InterfaceFrame reference_frame(const Model& model, const Interface& interface);

// Stiffness (N/m) of the four rows under a law; see JointMaterial for the parameters.
Vec4 interface_stiffness(const Model& model, const Interface& interface, InterfaceLaw law);

// An element with everything but the geometry, which set_geometry fills.
InterfaceElement make_element(const Model& model, const Interface& interface, InterfaceLaw law);
void set_geometry(const Model& model, const InterfaceFrame& frame, InterfaceElement& element);

}  // namespace dda
