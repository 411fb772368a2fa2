// What loads on the faces of joints that go by the stresses of their blocks make of these, as the water in one does.
//
// A block whose face bears a load t there has a stress with that traction and the joint's: sigma n = T + t on block a,
// T - t on block b (n from a into b). The law (projected_law.h) goes by the block's own traction, which is therefore
// sigma n - t and sigma n + t. What that adds to t_a and t_b shifts the gap, by softness times it, and is taken off the
// block with the rest. Water of pressure p adds p to both: the joint carries the effective traction, blocks the whole
// stress, and where a joint is closed and stuck nothing moves, however high the water is.
//
// A consistent joint that can break carries the mean of both own tractions, and what its gaps add. There loads are in
// the force alone, with the share that the block's stress has, and of one that varies with the moment that its ends
// bear.
//
// A load that varies along a projected stretch has a moment, which the law's two points bear by the stiffness of their
// turn: they are shifted by what makes that moment. Loads are those of the moment at which a step ends, as everywhere:
// the change acts like a load whose place is the gap, and its work, and what it makes of the energy stored, count as
// external.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/model/model.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/load_time.h"

namespace dda {

class FaceLoads {
 public:
  explicit FaceLoads(const Model& model);

  // Lists the faces anew, when contacts may be others than they were.
  void list(const Model& model, const ContactSet& contacts);

  // From now on the loads are those of this moment; forces of the start follow at once.
  void take(const LoadTime& time, BlockSystem& system);

  // A step is posed that ends at that moment: what the loads add to internal forces is in the balance with the weight
  // of the end's forces (BlockForces::by_faces).
  void pose(const LoadTime& time, BlockSystem& system);
  // It is not taken, or posed again: the system is as it was before.
  void take_back(BlockSystem& system);
  // It is taken, with the system's increment.
  void accept(BlockSystem& system);

 private:
  // A load on the face of a block along a stretch.
  struct Face {
    std::size_t stretch;
    bool of_b;
    std::size_t load;  // of the model's edge loads
    Vec2 mean, rise;   // Pa, times its history, in x and y: over the whole stretch, and from its middle to its end
  };

  // What of an element follows the loads.
  struct Part {
    Vec2 beside_stress_a, beside_stress_b;
    Vec4 by_loads;
    bool operator==(const Part&) const = default;
  };

  struct Change {
    std::size_t stretch;
    Part part;
  };

  // A stretch as it was before a step was posed.
  struct Before {
    std::size_t stretch;
    Part part;
    InterfaceState state;
  };

  // Lists the stretches whose loads are others at that moment.
  void find_changes(const LoadTime& time, const BlockSystem& system);
  void count_from_joining(BlockSystem& system) const;
  static void add_load(const Face& face, const LoadTime& time, std::size_t stage, const BlockSystem& system,
                       Part& part);
  static void follow(const Part& part, InterfaceElement& element, InterfaceState& state);
  static Part part_of(const InterfaceElement& element);
  static void set_part(const Part& part, InterfaceElement& element);

  std::vector<std::vector<std::size_t>> loads_of_block_;
  std::vector<Face> faces_;  // by stretch
  std::vector<Change> changes_;
  std::vector<Before> before_;
  double stored_ = 0;  // J per m of thickness, by which what is stored grew
};

}  // namespace dda
