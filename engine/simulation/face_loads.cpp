#include "engine/simulation/face_loads.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "engine/contact/join_blocks.h"
#include "engine/contact/make_element.h"
#include "engine/contact/projected_law.h"
#include "engine/contact/projected_stretch.h"
#include "engine/contact/tied_sides.h"
#include "engine/geometry/segment.h"
#include "engine/linear/block_vectors.h"
#include "engine/model/edge_loads_of_blocks.h"

namespace dda {
namespace {

// A load along a stretch: its mean over the whole, and what it is more at the end than in the middle where it goes
// in a straight line, with the moment that it has about the middle.
struct AlongStretch {
  Vec2 mean, rise;  // Pa
};

std::optional<AlongStretch> along(const EdgeLoad& load, const Interface& stretch, double tolerance) {
  const auto both = collinear_overlap({stretch.from, stretch.to}, {load.from, load.to}, tolerance);
  if (!both) return {};
  const auto& [first, last] = *both;
  const Vec2 edge = load.to - load.from;
  const auto traction_at = [&](const Vec2& point) -> Vec2 {
    return load.traction + (2 * edge.dot(point - load.from) / edge.squaredNorm() - 1) * load.rise;
  };
  const double share = (last - first).norm() / stretch.length;
  const Vec2 off_middle = (first + last - stretch.from - stretch.to) / 2;
  const double place = off_middle.dot(stretch.to - stretch.from) / (stretch.length * stretch.length);
  const Vec2 mean = share * traction_at((first + last) / 2);
  return AlongStretch{mean, 6 * place * mean + share * share * (traction_at(last) - traction_at(first)) / 2};
}

// What a face of the block adds to the block's own traction, by the directions of the stretch as it lies.
Vec2 beside_stress(const EdgeLoad& load, bool of_b, const Vec2& traction, const Interface& stretch,
                   const InterfaceElement& element) {
  const Mat2 axes = local_axes(load.follows ? stretch.normal : normal_of(element));
  return (of_b ? 1 : -1) * (axes * traction);
}

// Joints whose forces follow the stresses of their blocks, and which can open.
bool goes_by_stress(const Model& model, const Interface& stretch, const InterfaceElement& element) {
  const bool bonded = model.joints[static_cast<std::size_t>(stretch.joint)].bonded;
  return element.law == InterfaceLaw::projected || (element.law == InterfaceLaw::consistent && !bonded);
}

// The share of a face's block in the traction of a consistent joint.
double share_of(const Model& model, bool of_b, const InterfaceElement& element) {
  return of_b ? stress_share(model, element.block_b, element.block_a)
              : stress_share(model, element.block_a, element.block_b);
}

}  // namespace

FaceLoads::FaceLoads(const Model& model) {
  if (!model.edge_loads.empty()) loads_of_block_ = edge_loads_of_blocks(model);
}

void FaceLoads::list(const Model& model, const ContactSet& contacts) {
  faces_.clear();
  if (loads_of_block_.empty()) return;
  for (std::size_t k = 0; k < contacts.interfaces.size(); ++k) {
    const Interface& stretch = contacts.interfaces[k];
    if (!goes_by_stress(model, stretch, contacts.elements.but_for_blocks(k))) continue;
    for (const bool of_b : {false, true})
      for (const std::size_t i : loads_of_block_[static_cast<std::size_t>(of_b ? stretch.block_b : stretch.block_a)])
        if (const auto load = along(model.edge_loads[i], stretch, model.length_tolerance))
          faces_.push_back({k, of_b, i, load->mean, load->rise});
  }
}

void FaceLoads::take(const LoadTime& time, BlockSystem& system) {
  count_from_joining(system);
  pose(time, system);
  Eigen::VectorXd& added = system.forces.by_faces;
  if (added.size() == 0) return;
  system.forces.internal_old += added;
  system.audit.rock_changed(0, 0, stored_);
  added.resize(0);
}

void FaceLoads::pose(const LoadTime& time, BlockSystem& system) {
  find_changes(time, system);
  if (changes_.empty()) return;
  const double stored = system.stored_energy_now().contact;
  before_.clear();
  for (const auto& [stretch, change] : changes_) {
    InterfaceElement& element = system.contacts.elements.edit()[stretch];
    InterfaceState& state = system.contacts.states[stretch];
    before_.push_back({stretch, part_of(element), state});
    follow(change, element, state);
  }
  take_off_blocks(system.model, system.contacts);
  Eigen::VectorXd& added = system.forces.by_faces;
  added.resize(system.forces.internal_old.size());
  system.sum_internal_forces(added);
  added -= system.forces.internal_old;
  stored_ = system.stored_energy_now().contact - stored;
}

void FaceLoads::take_back(BlockSystem& system) {
  if (system.forces.by_faces.size() == 0) return;
  for (const Before& before : before_) {
    InterfaceElement& element = system.contacts.elements.edit()[before.stretch];
    if (!goes_by_stress(system.model, system.contacts.interfaces[before.stretch], element)) continue;  // it broke
    set_part(before.part, element);
    system.contacts.states[before.stretch] = before.state;
  }
  take_off_blocks(system.model, system.contacts);
  system.forces.by_faces.resize(0);
}

// Own tractions of blocks that were there count from when blocks that come in are joined to them (join_blocks.h), with
// what loads on their faces had made of them until then.
void FaceLoads::count_from_joining(BlockSystem& s) const {
  const std::vector<int>& added = s.stage().rock.added;
  if (added.empty()) return;
  const auto comes_in = [&added](int block) { return std::ranges::find(added, block) != added.end(); };
  for (const Face& face : faces_) {
    const Interface& stretch = s.contacts.interfaces[face.stretch];
    const bool is_new = comes_in(stretch.block_a) || comes_in(stretch.block_b);
    if (!is_new || comes_in(face.of_b ? stretch.block_b : stretch.block_a)) continue;
    Part part{Vec2::Zero(), Vec2::Zero(), Vec4::Zero()};
    add_load(face, LoadTime::at(s.state.time), s.clock.stage - 1, s, part);
    InterfaceElement& element = s.contacts.elements.edit()[face.stretch];
    element.by_loads += part.by_loads;
    if (element.law == InterfaceLaw::consistent) {
      element.force_at_start += part.by_loads;
      continue;
    }
    element.gap_at_start += part.by_loads;
    element.force_at_start += element.length * (Vec4() << part.beside_stress_a, part.beside_stress_b).finished();
  }
}

// The ledger takes the work of internal forces by those of the start and the end of a step, where these were added to
// the start at once.
void FaceLoads::accept(BlockSystem& system) {
  Eigen::VectorXd& added = system.forces.by_faces;
  if (added.size() == 0) return;
  system.audit.rock_changed(0, 0, stored_);
  system.audit.moved_against(dot(system.increment, added) / 2);
  added.resize(0);
}

void FaceLoads::find_changes(const LoadTime& time, const BlockSystem& s) {
  changes_.clear();
  for (auto face = faces_.begin(); face != faces_.end();) {
    const std::size_t k = face->stretch;
    const Interface& stretch = s.contacts.interfaces[k];
    const InterfaceElement& element = s.contacts.elements.own()[k];
    Part part{Vec2::Zero(), Vec2::Zero(), Vec4::Zero()};
    if (element.law == InterfaceLaw::projected) {
      part.beside_stress_a =
          traction_by_weight(s.model, stretch.block_a, stretch) - traction_when_joined(element, false);
      part.beside_stress_b =
          traction_by_weight(s.model, stretch.block_b, stretch) - traction_when_joined(element, true);
    }
    for (; face != faces_.end() && face->stretch == k; ++face) add_load(*face, time, s.clock.in_force(), s, part);
    if (part != part_of(element)) changes_.push_back({k, part});
  }
}

void FaceLoads::add_load(const Face& face, const LoadTime& time, std::size_t stage, const BlockSystem& s, Part& part) {
  const EdgeLoad& load = s.model.edge_loads[face.load];
  if (!load.stages.has(stage)) return;
  const InterfaceElement& element = s.contacts.elements.own()[face.stretch];
  const double now = time.of([&](double then) { return evaluate(load.history, then); });
  const auto added = [&](const Vec2& traction) {
    return beside_stress(load, face.of_b, now * traction, s.contacts.interfaces[face.stretch], element);
  };
  const Vec2 mean = added(face.mean), rise = added(face.rise) / 3;
  if (element.law == InterfaceLaw::consistent) {
    part.by_loads += share_of(s.model, face.of_b, element) * element.length * (Vec4() << mean, rise).finished();
    return;
  }
  (face.of_b ? part.beside_stress_b : part.beside_stress_a) += mean;
  const Vec2 at_points = rise / element.lever;
  part.by_loads += element.softness(face.of_b ? 1 : 0) * (Vec4() << mean - at_points, mean + at_points).finished();
}

void FaceLoads::follow(const Part& part, InterfaceElement& element, InterfaceState& state) {
  const Vec4 change = part.by_loads - element.by_loads;
  set_part(part, element);
  if (element.law == InterfaceLaw::consistent) {
    state.force += change;
    return;
  }
  state.gap += change;
  answer_gaps(element, state);
}

FaceLoads::Part FaceLoads::part_of(const InterfaceElement& element) {
  return {element.beside_stress_a, element.beside_stress_b, element.by_loads};
}

void FaceLoads::set_part(const Part& part, InterfaceElement& element) {
  element.beside_stress_a = part.beside_stress_a;
  element.beside_stress_b = part.beside_stress_b;
  element.by_loads = part.by_loads;
}

}  // namespace dda
