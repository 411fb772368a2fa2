#include "engine/advice/plane_wave_conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "engine/advice/acting_place.h"
#include "engine/advice/chain_path.h"
#include "engine/advice/closed_joints.h"
#include "engine/advice/on_the_way.h"
#include "engine/advice/reach.h"
#include "engine/advice/stages_on_the_way.h"
#include "engine/advice/ties.h"
#include "engine/model/held_motion.h"
#include "engine/model/stage_times.h"

namespace dda {
namespace {

constexpr double tolerance = 1e-6;    // of lengths, over the size of a block; of directions and values
constexpr double hardly_ties = 1e-3;  // of the rock's stiffness along the way: half of that of speed

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// One entry of the scene that acts with a history.
struct Drive {
  int block = 0;
  ActingPlace acting;
  Vec2 place = Vec2::Zero();  // m, the middle of that
  Vec2 amplitude = Vec2::Zero();
  const TimeFunction* history = nullptr;
  bool moves = false;  // what it acts on, in place of pushing it
  double length = 0;   // m, of the edge that it acts on
};

std::vector<Drive> drives_of(const Model& model, std::size_t stage) {
  std::vector<Drive> drives;
  const auto add = [&](const Drive& drive) {
    if (!std::holds_alternative<Constant>(*drive.history)) drives.push_back(drive);
  };
  for (const EdgeLoad& load : model.edge_loads)
    if (load.stages.has(stage) && !load.traction.isZero(0))
      add({load.block, place_of(load), (load.from + load.to) / 2, load.traction, &load.history, false,
           (load.to - load.from).norm()});
  for (const PointLoad& load : model.point_loads)
    if (load.stages.has(stage) && !load.force.isZero(0))
      add({load.block, place_of(load), load.point, load.force, &load.history});
  for (const PointSupport& support : model.supports)
    if ((support.last_stage < 0 || support.last_stage >= static_cast<int>(stage)) && !support.amplitude.isZero(0))
      add({support.block, place_of(support), support.point, support.amplitude, &support.history, true});
  for (const HeldBlock& held : model.held_blocks)
    if (moves(held))
      add({held.block, place_of(held), model.blocks[at(held.block)].moments.centroid, held.amplitude, &held.history,
           true});
  return drives;
}

// At times that no period of a history falls in with.
bool are_alike(const TimeFunction& a, const TimeFunction& b, double end) {
  constexpr int times = 32;
  double largest = 0, apart = 0;
  for (int i = 1; i <= times; ++i) {
    const double t = end * std::fmod(0.6180339887498949 * i, 1.0);
    const double of_a = evaluate(a, t), of_b = evaluate(b, t);
    largest = std::max({largest, std::abs(of_a), std::abs(of_b)});
    apart = std::max(apart, std::abs(of_a - of_b));
  }
  return a.index() == b.index() && apart <= tolerance * largest;
}

class Conditions {
 public:
  Conditions(const Model& model, std::size_t stage, const SceneLoad& load, const DrivenWave& wave,
             const std::vector<LoadFinding>& sudden)
      : model_(model),
        stage_(static_cast<int>(stage)),
        load_(load),
        wave_(wave),
        sudden_(sudden),
        slack_(tolerance * std::sqrt(model.blocks[at(load.block)].moments.area)) {
    for (const Drive& drive : drives_of(model, stage)) (is_of_the_load(drive) ? own_ : others_).push_back(drive);
  }

  [[nodiscard]] std::string run() const {
    if (std::ranges::any_of(others_,
                            [&](const Drive& drive) { return is_seen(drive.acting, start_of(*drive.history)); }))
      return "something else that acts in time, or moves, is seen there as well";
    if (std::ranges::any_of(sudden_, [&](const LoadFinding& finding) { return is_seen_to_jump(finding); }))
      return "something else jumps, and is seen there as well";
    if (std::ranges::any_of(sudden_, [&](const LoadFinding& finding) { return comes_or_goes_on_the_way(finding); }))
      return "it jumps as another stage begins, and that is seen as well";
    if (const std::string name = tied_by(); !name.empty()) return fmt::format("{} ties blocks that it passes", name);
    if (std::string clause = met_on_the_way(); !clause.empty()) return clause;
    if (is_in_motion_before()) return "blocks begin in motion, which is seen there as well";
    if (!wave_.row && !moved() && load_.face.isZero(0)) return "a load at a point of a mesh spreads to all sides";
    if (!wave_.row && !is_on_all_of_a_side()) return "what drives it does not act on all of a side";
    if (meets_its_echo())
      return "the far end absorbs it but for what springs at joints send back, which is there before all of it has "
             "come";
    if (moved()) return "";
    if (is_held()) return "what is loaded is held there as well";
    return absorbs() ? "the edge that is loaded absorbs as well" : "";
  }

 private:
  [[nodiscard]] bool moved() const { return static_cast<bool>(load_.history.displacement); }
  [[nodiscard]] double along(const Vec2& point) const { return wave_.direction.dot(point); }

  // On one side of a mesh, or anywhere on the first block of a row, and with one history.
  [[nodiscard]] bool is_of_the_load(const Drive& drive) const {
    if (drive.moves != moved() || !are_alike(*drive.history, *load_.source, end_of_run(model_))) return false;
    if (wave_.row && drive.block == load_.block) return true;
    const double start = drive.acting.all_of_it ? front_of(drive.block) : along(drive.place);
    return std::abs(start - front()) <= slack_ &&
           (drive.amplitude - load_.motion).norm() <= tolerance * load_.motion.norm();
  }

  // Whether anything that begins there by `start` (s in the run) is in time to be seen where the wave is looked at.
  [[nodiscard]] bool is_seen(const ActingPlace& place, double start) const {
    const bool is_measured = (load_.looked_at - load_.place).norm() > slack_;
    const Vec2 seen = is_measured ? load_.looked_at : Vec2(load_.place + wave_.distance * wave_.direction);
    return distance(model_, place, seen) < fastest() * (load_.history.start + wave_.timing.window - start);
  }

  [[nodiscard]] double fastest() const {
    double fastest = 0;
    for (const Material& material : model_.materials) fastest = std::max(fastest, p_wave_speed(material));
    return fastest;
  }

  // The stiffest bolt or lining that the wave meets in time to be seen, where all of these together, spread along the
  // way, are felt beside the rock's own stiffness; else empty.
  [[nodiscard]] std::string tied_by() const {
    double all = 0, most = 0;
    std::string name;
    for (const Tie& tie : ties_in(model_, at(stage_))) {
      if (!is_seen(tie.place, load_.history.start + reached(tie.place) / fastest())) continue;
      all += tie.stiffness * tie.length;
      if (tie.stiffness <= most) continue;
      most = tie.stiffness;
      name = tie.name;
    }
    return all > hardly_ties * softest() * width() * wave_.distance ? name : "";
  }

  // What holds or absorbs along a row, and blocks that are not there. What holds or absorbs in meshes is looked at
  // where their sides are (near_sides.h).
  [[nodiscard]] std::string met_on_the_way() const {
    std::vector<Hindrance> hindrances = missing_blocks(model_, at(stage_), wave_.direction);
    if (wave_.row)
      for (Hindrance& each : holding_or_absorbing(
               model_, at(stage_), {wave_.direction, load_.motion.normalized(), 1 / load_.history.period, width()}))
        if (!is_driven(each.place.block)) hindrances.push_back(std::move(each));
    double all = 0, most = 0;
    std::string clause;
    for (const Hindrance& each : hindrances) {
      const double start = load_.history.start + reached(each.place) / fastest();
      if (!is_seen(each.place, start)) continue;
      all += each.share;
      if (each.share <= most) continue;
      most = each.share;
      clause = each.clause;
    }
    return all > hardly_held ? clause : "";
  }

  // m along the way, to where a place begins.
  [[nodiscard]] double reached(const ActingPlace& place) const {
    return std::max(0.0, reach_of(model_, place, wave_.direction).low - front());
  }

  // As a whole, all blocks alike, it changes no stress.
  [[nodiscard]] bool is_in_motion_before() const {
    if (last_calm_stage() >= 0) return false;
    const Vec2& common = model_.blocks[at(load_.block)].initial_velocity;
    for (std::size_t i = 0; i < model_.blocks.size(); ++i) {
      const Block& block = model_.blocks[i];
      const bool moves_along = block.initial_velocity == common && block.initial_spin == 0;
      const ActingPlace place{.block = static_cast<int>(i), .all_of_it = true};
      if (!(moves_along && block.initial_strain_rate.isZero(0)) && is_seen(place, 0)) return true;
    }
    return false;
  }

  [[nodiscard]] double softest() const {
    double young = std::numeric_limits<double>::infinity();
    for (const Material& material : model_.materials) young = std::min(young, material.young);
    return young;
  }

  // m, of the scene across the way.
  [[nodiscard]] double width() const { return reach_of(model_, left_of(wave_.direction)).length(); }

  // In a stage before, too, which nothing has calmed since, or in one after.
  [[nodiscard]] bool is_seen_to_jump(const LoadFinding& finding) const {
    return finding.history != load_.source && is_seen(finding);
  }

  // A jump in the stage of the wave has a sentence of its own (no_figures.h).
  [[nodiscard]] bool comes_or_goes_on_the_way(const LoadFinding& finding) const {
    return finding.history == load_.source && finding.stage != stage_ && is_seen(finding);
  }

  [[nodiscard]] bool is_seen(const LoadFinding& finding) const {
    if (finding.stage <= last_calm_stage() || finding.leaves_figures) return false;
    return std::ranges::any_of(finding.places, [&](const ActingPlace& place) { return is_seen(place, finding.time); });
  }

  // The last one before that of the wave which leaves nothing to swing; -1: none.
  [[nodiscard]] int last_calm_stage() const {
    for (int i = stage_ - 1; i >= 0; --i) {
      const Stage& stage = model_.stages[at(i)];
      if (stage.integrator.is_static || stage.velocity_factor != 1 || stage.damping_rate > 0 ||
          stage.material_damping.mass > 0)
        return i;
    }
    return -1;
  }

  // An end that absorbs should send nothing back, so that what it does is an error that no figure counts: springs at
  // joints make another impedance of the rock's. What other ends send back belongs to the scene.
  [[nodiscard]] bool meets_its_echo() const {
    const double far = reach_of(model_, wave_.direction).high;
    const double echo = wave_.timing.front * (2 * (far - front()) / wave_.distance - 1);
    return has_springs() && is_absorbed_at(far) && lasts(echo - wave_.timing.front, echo);
  }

  // Whether there is any load to speak of `time` (s) after its begin, in a run that goes on until `seen` (s).
  [[nodiscard]] bool lasts(double time, double seen) const {
    constexpr int samples = 4000;
    constexpr double little = 1e-4;  // of its square: a hundredth of the wave
    if (seen >= load_.history.run) return false;
    double whole = 0, later = 0;
    for (int i = 0; i < samples; ++i) {
      const double t = (i + 0.5) / samples * load_.history.run;
      const double square = std::pow(load_.history.value(t), 2);
      whole += square;
      if (t > time) later += square;
    }
    return later > little * whole;
  }

  [[nodiscard]] bool is_absorbed_at(double far) const {
    return std::ranges::any_of(model_.viscous_edges, [&](const ViscousEdge& edge) {
      return edge.first_stage <= stage_ && std::abs(along(edge.from) - far) <= slack_ &&
             std::abs(along(edge.to) - far) <= slack_;
    });
  }

  [[nodiscard]] bool has_springs() const {
    return one_gives_way_closed(model_.joints, model_.stages[at(stage_)].kinematics);
  }

  [[nodiscard]] bool is_driven(int block) const {
    return std::ranges::any_of(own_, [&](const Drive& drive) { return drive.block == block; });
  }

  // m along the way, of the face that sends the wave out.
  [[nodiscard]] double front() const {
    return model_.is_held(load_.block) ? front_of(load_.block) : along(load_.place);
  }
  // The same of a block that sends it out as a whole.
  [[nodiscard]] double front_of(int block) const { return reach_of(model_.blocks[at(block)], wave_.direction).high; }

  // No rock lies before it, and all that ends at it is driven.
  [[nodiscard]] bool is_on_all_of_a_side() const {
    const bool whole_blocks = model_.is_held(load_.block);
    const double side = front();
    double there = 0, driven = 0;
    for (const Drive& drive : own_) driven += drive.length;
    for (std::size_t i = 0; i < model_.blocks.size(); ++i) {
      const double length = length_at(model_.blocks[i].shape.outer, wave_.direction, side, slack_);
      const bool before = along(model_.blocks[i].moments.centroid) < side;
      if (before && !(whole_blocks && is_driven(static_cast<int>(i)))) return false;
      if (!before && moved() && !whole_blocks && length > 0 && !is_driven(static_cast<int>(i))) return false;
      there += length;
    }
    return moved() || std::abs(driven - there) <= tolerance * there;
  }

  [[nodiscard]] bool is_held() const {
    const Vec2 motion = load_.motion.normalized();
    return std::ranges::any_of(model_.supports, [&](const PointSupport& support) {
      if (!is_driven(support.block) || !is_still(support)) return false;
      if (support.last_stage >= 0 && support.last_stage < stage_) return false;
      const Vec2 held = support.direction.isZero(0)
                            ? Vec2(support.holds_x ? motion.x() : 0, support.holds_y ? motion.y() : 0)
                            : Vec2(support.direction.dot(motion) * support.direction);
      return held.norm() > tolerance;
    });
  }

  [[nodiscard]] bool absorbs() const {
    return std::ranges::any_of(model_.viscous_edges, [&](const ViscousEdge& edge) {
      const Vec2 tangent = (edge.to - edge.from).normalized();
      return is_driven(edge.block) && edge.first_stage <= stage_ && std::abs(along(tangent)) <= tolerance &&
             along(model_.blocks[at(edge.block)].moments.centroid - edge.from) > 0;
    });
  }

  const Model& model_;
  int stage_;
  const SceneLoad& load_;
  const DrivenWave& wave_;
  const std::vector<LoadFinding>& sudden_;
  double slack_;  // m
  std::vector<Drive> own_, others_;
};

}  // namespace

std::string why_no_plane_wave(const Model& model, std::size_t stage, const SceneLoad& load, const DrivenWave& wave,
                              const std::vector<LoadFinding>& sudden) {
  return Conditions(model, stage, load, wave, sudden).run();
}

}  // namespace dda
