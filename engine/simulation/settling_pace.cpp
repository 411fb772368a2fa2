#include "engine/simulation/settling_pace.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/model/extent.h"
#include "engine/model/gives_way.h"

namespace dda {
namespace {

// In transit times.
constexpr double longest = 1e2;
constexpr double first_with_friction = 1;
constexpr double shortest = 1e-4;

// A step can be this share of sqrt(D/g) long, the time in which weight moves blocks by the diameter of the scene, where
// that is more than the longest in transit times: what weight alone holds, as a hinged arch, has a period of some
// sqrt(D/g).
constexpr double longest_by_weight = 0.3;

// Where something gives way for good the first long step is so long that inertia is nothing: with a little of it soft
// bolts carry less, and stiff ones more, than they will, and yield by it. (Bolts with 5 to 20 % more than they must
// carry yielded in 9 of 56 blocks that hung on three of them.)
constexpr double longest_where_something_gives_way = 1e4;

constexpr double long_enough = 0.5;  // of the longest, for inertia to be nothing beside friction

// Until a step was too long, and from then on. (Of steps that settle at any length passes are what counts: these grow
// fast whatever was.) Walls of 3,500 and 5,000 bricks settle after 412 and 350 passes, with the first throughout after
// 1,471 and 1,509; 40 random rocks take a tenth less time.
constexpr double fast_growth = 8;
constexpr double slow_growth = 2;
constexpr double shrinking = 8;

// Steps that took more passes than this are long enough; and of those that settle at any length, which take as many
// when they are longer, steps of more than this.
constexpr std::int64_t easy = 30;
constexpr std::int64_t easy_when_sure = 100;

// And steps that took more than this were too long, by so much: two shorter ones take less.
constexpr std::int64_t hard = 60;
constexpr double shrinking_after_hard = 4;

double transit_time(const Model& model) {
  double slowest = std::numeric_limits<double>::infinity();
  for (const Block& block : model.blocks) {
    const Material& rock = model.materials[static_cast<std::size_t>(block.material)];
    slowest = std::min(slowest, std::sqrt(rock.young / rock.density));
  }
  return diameter(model) / slowest;
}

double longest_step(const Model& model, double transit) {
  const double gravity = model.gravity.norm();
  const double by_weight = gravity > 0 ? longest_by_weight * std::sqrt(diameter(model) / gravity) : 0;
  return std::max(longest * transit, by_weight);
}

// Contacts that cannot slide make the step a convex problem, but where blocks move only that of one geometry.
bool is_convex(const Stage& stage, bool contacts_can_change) {
  return (stage.unlimited_strength && stage.kinematics == Kinematics::small) || !contacts_can_change;
}

// In transit times.
double long_first_step(const Model& model) {
  return something_gives_way(model) ? longest_where_something_gives_way : longest;
}

}  // namespace

double first_step(const Model& model, const Stage& stage, bool contacts_can_change) {
  if (!stage.paces_itself()) return stage.dt;
  return (is_convex(stage, contacts_can_change) ? long_first_step(model) : first_with_friction) * transit_time(model);
}

void SettlingPace::begin(const Model& model, const Stage& stage, bool contacts_can_change, bool in_parts) {
  transit_ = transit_time(model);
  longest_ = longest_step(model, transit_);
  is_convex_ = is_convex(stage, contacts_can_change);
  growth_ = fast_growth;
  in_parts_ = in_parts;
  tries_ = !is_convex_ && (!in_parts || something_gives_way(model));
  dt_ = tries_ ? long_first_step(model) * transit_ : first_step(model, stage, contacts_can_change);
}

void SettlingPace::settled(std::int64_t passes, bool is_sure) {
  if (passes <= (is_sure ? easy_when_sure : easy)) dt_ = std::min((is_sure ? fast_growth : growth_) * dt_, longest_);
  if (passes > hard && !is_convex_ && !is_sure) dt_ = std::max(dt_ / shrinking_after_hard, shortest * transit_);
}

Taken SettlingPace::taken() const {
  if (tries_) return Taken::if_hardly_slips;
  return is_convex_ || is_shortest() ? Taken::to_the_end : Taken::unless_cut;
}

void SettlingPace::tried(bool was_taken) {
  tries_ = false;
  if (!was_taken) dt_ = first_with_friction * transit_;
}

bool SettlingPace::shorten() {
  if (is_shortest()) return false;
  if (!in_parts_) growth_ = slow_growth;
  dt_ = std::max(dt_ / shrinking, shortest * transit_);
  return true;
}

bool SettlingPace::is_long() const { return dt_ >= long_enough * longest_; }

bool SettlingPace::is_shortest() const { return dt_ <= shortest * transit_; }

}  // namespace dda
