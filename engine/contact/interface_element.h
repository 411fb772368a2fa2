// The linear kinematics and stiffness of one interface, in one form for all laws.
//
// An interface sees four gaps g (block b minus block a; normal: opening positive; tangent: counter-clockwise from the
// normal), rows of g = rows_a d_a + rows_b d_b:
//   classical:  0, 1 = normal, tangential gap at `from`;  2, 3 = the same at `to`             (Shi's corner springs)
//   consistent: 0, 1 = the same at the middle;            2, 3 = half of (to - from)          (Nitsche at mid-edge)
//   cubic:      0, 1 = the same at the middle;            2 = jump of the normal strain times half the centroids'
//               distance; 3 = half of (to - from) of the normal gap                           (see cubic_law.h)
//   projected:  as classical, at two points nearer the middle, and each gap with what the stresses of both blocks
//               make of it                                                                    (see projected_law.h)
// and four conjugate forces (N per m of thickness, tension positive)
//   f = stiffness * g + stress_rows_a sigma_a + stress_rows_b sigma_b + by_loads - force_at_start
// where stress rows are none in the classical and projected law, and give length * {sigma} n, the mean of tractions,
// on rows 0 and 1 of the others. All follow from the potential 1/2 g K g + g . (stress rows), which makes them
// symmetric: the blocks' strains carry the extra forces strain_rows^T g, strain_rows = stress_rows * elasticity.
#pragma once

#include <array>
#include <type_traits>

#include "engine/contact/interface.h"
#include "engine/core/types.h"
#include "engine/model/model.h"

namespace dda {

using Vec4 = Eigen::Vector4d;
using Mat46 = Eigen::Matrix<double, 4, 6, Eigen::RowMajor>;  // the rows of a lone vertex lie together
using Mat43 = Eigen::Matrix<double, 4, 3>;

// All that the laws of the open-close iteration look at.
struct InterfaceSprings {
  InterfaceLaw law = InterfaceLaw::classical;
  double length = 0;
  double lever = 1;             // of the two points of a projected stretch: their distance over its length
  double spread = 0;            // of a projected stretch: the closed part, of its length, below which load spreads
  Vec4 stiffness;               // N/m per m of thickness, of each row while it is closed and stuck
  Vec4 dashpot = Vec4::Zero();  // N s/m per m of thickness, of each row while it is closed and stuck

  template <typename Self, typename Archive>
  static void visit_springs(Self& self, Archive& archive) {
    auto& [law, length, lever, spread, stiffness, dashpot] = self;
    archive(law, length, lever, spread, stiffness, dashpot);
  }
};

struct InterfaceElement : InterfaceSprings {
  int block_a = 0;
  int block_b = 0;
  Vec2 softness = Vec2::Zero();  // m/Pa, of a projected stretch: the gap that the traction of a, of b makes
  // Pa, normal and shear, of a projected stretch: what the own traction of a, of b there is beside that of its stress,
  // by its weight and by loads on its face.
  Vec2 beside_stress_a = Vec2::Zero(), beside_stress_b = Vec2::Zero();
  // By how much loads on its faces open the gaps of a projected stretch, m, or what they are in the force of a
  // consistent joint, N per m of thickness (simulation/face_loads.h).
  Vec4 by_loads = Vec4::Zero();
  Mat46 rows_a, rows_b;
  Mat43 stress_rows_a, stress_rows_b;  // m; not set where there are none
  Mat43 strain_rows_a, strain_rows_b;  // N per m of thickness; not set where there are none
  // What gap and force would have been when blocks that had moved, and bore stress, were joined, or springs changed
  // (renew_springs.h): gaps count from there where measured, forces with stress rows, and by join_blocks.h.
  Vec4 gap_at_start = Vec4::Zero(), force_at_start = Vec4::Zero();

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive);
};

// A vertex on an edge or against another vertex: its second end (rows 2 and 3) is not there.
inline bool is_lone_vertex(const InterfaceSprings& springs) { return springs.length == 0; }
inline int ends_of(const InterfaceSprings& springs) { return is_lone_vertex(springs) ? 1 : 2; }

// The row that the first one can be coupled to: the normal of the other end of a stretch on a bed, or the shear of a
// lone vertex that rides up as it slides.
inline Eigen::Index coupled_row(const InterfaceSprings& springs) { return is_lone_vertex(springs) ? 1 : 2; }

inline bool has_stress_rows(const InterfaceSprings& springs) { return passes_stress(springs.law); }

// Those that carry their blocks' stresses are linear until they break, and then are no longer what they were.
inline bool can_open_or_slide(const InterfaceSprings& springs) { return !has_stress_rows(springs); }

// N/m per m of thickness, of all ends together against blocks that move straight towards each other.
inline double normal_stiffness(const InterfaceSprings& springs) {
  return has_stress_rows(springs) ? springs.stiffness(0) : springs.stiffness(0) + springs.stiffness(2);
}

template <typename Self, typename Archive>
void InterfaceElement::visit(Self& self, Archive& archive) {
  // A member more, and this no longer compiles: it must be visited too.
  struct Members : InterfaceSprings {
    std::array<int, 2> blocks;
    Vec2 softness;
    std::array<Vec2, 2> beside_stress;
    Vec4 by_loads;
    std::array<Mat46, 2> rows;
    std::array<Mat43, 4> stress_rows;
    std::array<Vec4, 2> at_start;
  };
  static_assert(sizeof(InterfaceElement) == sizeof(Members));
  using OwnSprings = std::conditional_t<std::is_const_v<Self>, const InterfaceSprings, InterfaceSprings>;
  InterfaceSprings::visit_springs(static_cast<OwnSprings&>(self), archive);
  archive.blocks(self.block_a, self.block_b);
  archive(self.softness, self.beside_stress_a, self.beside_stress_b, self.by_loads, self.rows_a, self.rows_b,
          self.gap_at_start, self.force_at_start);
  if (has_stress_rows(self)) archive(self.stress_rows_a, self.stress_rows_b, self.strain_rows_a, self.strain_rows_b);
}

// What an interface adds to a symmetric matrix over the unknowns of its blocks a and b: stiffness (N/m per m of
// thickness and so on) or inertia. ba: on b by the unknowns of a.
struct InterfaceMatrices {
  Mat6 aa, bb, ba;
};

// The frame of an interface: its ends as seen by each block, its normal, and where the blocks' centroids are. Places
// are local where blocks have moved, and those of the drawing in the reference geometry.
struct InterfaceFrame {
  Vec2 from_a, to_a, from_b, to_b;
  Vec2 normal;
  Vec2 centroid_a, centroid_b;
};

// From a into b, as the rows have it.
inline Vec2 normal_of(const InterfaceElement& element) { return {element.rows_b(0, 0), element.rows_b(0, 1)}; }

// Rows (normal, tangent): the local components of a global vector.
Mat2 local_axes(const Vec2& normal);

// Local components of the displacement that the unknowns of a block make at `offset` from its centroid.
Mat26 local_rows(const Mat2& axes, const Vec2& offset);

// Frame in the reference geometry.
InterfaceFrame reference_frame(const Model& model, const Interface& interface);

}  // namespace dda
