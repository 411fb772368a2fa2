// The constant description of a problem: blocks, materials, loads, supports, stages. Built once by engine/scene (or by
// hand), never changed by a run. Indices refer to the vectors here. Points are in reference (as drawn) coordinates.
#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/types.h"
#include "engine/geometry/polygon.h"
#include "engine/model/lining.h"
#include "engine/model/material.h"
#include "engine/model/measurement.h"
#include "engine/model/motion.h"
#include "engine/model/peaks.h"
#include "engine/model/settings.h"
#include "engine/model/stage_span.h"
#include "engine/model/time_function.h"
#include "engine/model/withdrawal.h"

namespace dda {

struct Block {
  std::string name;
  Polygon shape;        // reference outline, outer ring counter-clockwise
  AreaMoments moments;  // of `shape`, m^2 and m^4
  int material = 0;
  Vec3 initial_stress = Vec3::Zero();       // Pa, tension positive
  Vec2 initial_velocity = Vec2::Zero();     // m/s, of the centroid
  double initial_spin = 0;                  // rad/s
  Vec3 initial_strain_rate = Vec3::Zero();  // 1/s: xx, yy and the engineering shear strain's

  [[nodiscard]] bool starts_at_rest() const {
    return initial_velocity.isZero(0) && initial_spin == 0 && initial_strain_rate.isZero(0);
  }
};

// Edges of blocks drawn along this line have the joint, whatever their pair of blocks says.
struct JointLine {
  Vec2 from, to;
  int joint = 0;
};

struct PointLoad {
  int block = 0;
  Vec2 point;  // material point of the block
  Vec2 force;  // N per m of thickness, times history
  TimeFunction history;
  StageSpan stages = {};  // in which it acts
};

struct EdgeLoad {
  int block = 0;
  Vec2 from, to;  // ends of the loaded stretch of the block's outline
  Vec2 traction;  // Pa, in x and y, times history: the mean along the stretch
  TimeFunction history;
  StageSpan stages = {};     // in which it acts
  Vec2 rise = Vec2::Zero();  // Pa, by which it is more than the mean at `to`, and less at `from`; in a straight line
  bool follows = false;      // turns with its stretch, as the pressure of a gas does; else directions stay as drawn
};

// A spring between a material point of a block and a point that moves as prescribed (or stands still).
struct PointSupport {
  int block = 0;
  Vec2 point;
  bool holds_x = true;
  bool holds_y = true;
  double stiffness = 0;           // N/m per m of thickness
  Vec2 amplitude = Vec2::Zero();  // m, m/s or m/s2 by `kind`: the prescribed motion, times history
  TimeFunction history;
  MotionKind kind = MotionKind::displacement;
  Vec2 direction = Vec2::Zero();   // unit; holds along it alone when it is not zero (a roller)
  int last_stage = -1;             // let go at the end of this stage; -1: never
  bool takes_force_along = false;  // when let go; else its force stays as a constant load
  std::optional<Vec2> partner =
      {};                 // another point of the block: the spring holds the way from there to `point` instead
  std::string name = {};  // of its entry in the scene; measurements call it by that
};

// A block held, or moved, as a rigid whole: exactly as prescribed whatever forces act on it. It belongs to the
// surroundings: it has no inertia, and its motion does external work on the rest. Several entries can move one block,
// each with a history of its own: they follow each other in the list, and their motions add up (held_motion.h).
struct HeldBlock {
  int block = 0;
  Vec2 amplitude = Vec2::Zero();  // m, m/s or m/s2 by `kind`, of the point `about`; times history
  double turn = 0;                // rad, rad/s or rad/s2 by `kind`, about the point `about`; times history
  Vec2 about = Vec2::Zero();      // as drawn; only asked where there is a turn
  TimeFunction history;
  MotionKind kind = MotionKind::displacement;
  std::string name = {};  // of its entry in the scene
};

// Where a bolt acts between two blocks: its two anchors, or the two sides of a joint that a grouted bolt crosses.
struct BoltLink {
  int block_a = 0, block_b = 1;
  Vec2 point_a, point_b;       // material points; the bolt runs from a to b
  double axial_stiffness = 0;  // N/m per m of thickness
  double shear_stiffness = 0;  // N/m per m of thickness, across the bolt: dowel action
  // m, of a grouted bolt before point_a and behind point_b: what is drawn with this link, up to half-way to the next or
  // to the bolt's end. Forces do not depend on it.
  double reach_a = 0, reach_b = 0;
};

// A straight rock bolt. Each link answers elongation with a force that is linear between its bounds, and yields at
// them without hardening. All forces per m of thickness.
struct Bolt {
  std::string name;
  Vec2 direction = Vec2::UnitX();  // unit, from the first end to the last, as drawn
  bool grouted = false;            // links turn with the blocks at their joint; else the line of action follows anchors
  std::vector<BoltLink> links;
  double pretension = 0;                                                // N, when it is put in
  double yield_force = std::numeric_limits<double>::infinity();         // N
  double shear_yield_force = std::numeric_limits<double>::infinity();   // N
  double rupture_elongation = std::numeric_limits<double>::infinity();  // m, of a link since then
  bool tension_only = true;                                             // goes slack instead of pushing
  double spacing = 1;   // m of thickness a bolt: what is measured is the force in one bolt, spacing times that here
  int first_stage = 0;  // put in at the start of this stage
  Withdrawal withdrawal = {};
};

// Absorbing (Lysmer-Kuhlemeyer) edge: traction = -impedance * velocity, integrated exactly along the edge.
struct ViscousEdge {
  int block = 0;
  Vec2 from, to;
  double normal_impedance = 0;  // Pa s/m, e.g. rho c_p
  double shear_impedance = 0;   // Pa s/m, e.g. rho c_s
  int first_stage = 0;          // acts from the start of this stage on
};

// A vertical side that goes with the ground beyond it (free field; Cundall et al. 1980). Beside it stands a column of
// the blocks along it, which deforms in one dimension on the base of the side. Its viscous edges act on the motion
// relative to that of the column and carry the column's stress; the column does not feel the model.
struct FreeFieldSide {
  std::vector<int> viscous_edges;  // the side, from below, end to end; all from the same first stage on
  double outward = 1;              // x of its outward normal: -1 on the left, 1 on the right
};

// What predictions and choices go by.
struct Expected {
  std::optional<double> frequency;  // Hz, the highest that matters; none: that of the loads
  double pressure = 0;  // Pa: most that weight, initial stress and loads press joints with; set by finish_model
};

// How exactly places are told. Both follow from the blocks, and are set by finish_model.
struct PrecisionOfPlaces {
  double length_tolerance = 0;  // m: points closer than this touch
  Vec2 origin = Vec2::Zero();   // as drawn: from here local places count (state.h)
};

struct Model : PrecisionOfPlaces {
  std::string title;
  std::vector<Material> materials;
  std::vector<JointMaterial> joints;                       // joints[0] is the default
  std::map<std::pair<int, int>, int> joint_of_block_pair;  // (smaller, larger block) -> joint, where not the default
  std::vector<JointLine> joint_lines;                      // a later one goes before an earlier one
  std::vector<Block> blocks;
  Vec2 gravity = Vec2::Zero();  // m/s2
  std::vector<PointLoad> point_loads;
  std::vector<EdgeLoad> edge_loads;
  std::vector<PointSupport> supports;
  std::vector<HeldBlock> held_blocks;
  std::vector<Bolt> bolts;
  std::vector<Lining> linings;
  std::vector<ViscousEdge> viscous_edges;
  std::vector<FreeFieldSide> free_field_sides;
  std::vector<Measurement> measurements;
  std::vector<Stage> stages;
  Expected expected;
  std::optional<PeakRequest> peaks = {};  // what is asked about the strongest motion

  [[nodiscard]] const Material& material_of(int block) const;
  // What it was before any stage began: joints' springs and penalties go by it.
  [[nodiscard]] const Material& material_at_start(int block) const;
  // Index into `joints` of the joint between two blocks.
  [[nodiscard]] int joint_index(int block_a, int block_b) const;
  [[nodiscard]] const JointMaterial& joint_between(int block_a, int block_b) const;
  // Nothing can change in any stage: all joints bonded, small kinematics, no bolts, linings that do not yield.
  [[nodiscard]] bool stays_linear() const;
  // The stage with those of its corrections for waves that act: in dynamic stages of runs that stay linear and whose
  // materials stay the same, without blocks that come in later. Static stages carry no waves, and forces that only such
  // stages know of would be missing when joints open or blocks move.
  [[nodiscard]] Stage with_acting_corrections(const Stage& stage) const;
  [[nodiscard]] bool is_held(int block) const;    // as a whole: one of held_blocks
  [[nodiscard]] double mass_of(int block) const;  // kg per m of thickness
  [[nodiscard]] double mass_at_start(int block) const;
  [[nodiscard]] bool removes_blocks() const;  // in some stage
  [[nodiscard]] bool adds_blocks() const;     // the same
  // For every block whether it is not there in `stage`: removed by then, or not added yet; empty where none is.
  [[nodiscard]] std::vector<bool> absent_in(std::size_t stage) const;
};

// Whether a later stage has other ones than the first.
bool changes_materials(const Model& model);
bool changes_joints(const Model& model);

// Fills what follows from the rest (area moments, length tolerance = 1e-9 of the extent, origin of local places,
// expected pressure) and checks the whole: throws InputError naming field, value and what was expected (indices in
// range, positive density, valid polygons, ...).
void finish_model(Model& model);

}  // namespace dda
