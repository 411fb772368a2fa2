#include "engine/simulation/bolt_set.h"

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

BoltLaw law_of(const Bolt& bolt, const BoltLink& link) {
  return {{link.axial_stiffness, link.shear_stiffness},
          {bolt.tension_only ? 0 : -bolt.yield_force, -bolt.shear_yield_force},
          {bolt.yield_force, bolt.shear_yield_force}};
}

// Direction of a bolt at the joint of two blocks: the mean of how both turned and stretched it.
Vec2 turned_with_blocks(const State& state, const BoltLink& link, const Vec2& direction) {
  return ((state.deformation[static_cast<std::size_t>(link.block_a)] +
           state.deformation[static_cast<std::size_t>(link.block_b)]) *
          direction)
      .normalized();
}

// Change of the distance of the anchors, without the cancellation of a difference of lengths.
double lengthening(const Vec2& drawn, const Vec2& change) {
  return change.dot(2 * drawn + change) / ((drawn + change).norm() + drawn.norm());
}

// Change of the way from anchor a to anchor b.
Vec2 change_of_span(const Model& model, const State& state, const BoltLink& drawn) {
  return point_displacement(model, state, drawn.block_b, drawn.point_b) -
         point_displacement(model, state, drawn.block_a, drawn.point_a);
}

Vec2 direction_in(const Model& model, const State& state, const Bolt& bolt, const BoltLink& drawn) {
  if (bolt.grouted) return turned_with_blocks(state, drawn, bolt.direction);
  return (drawn.point_b - drawn.point_a + change_of_span(model, state, drawn)).normalized();
}

// By how much the anchors have parted since they were drawn, along the bolt and, where it is grouted, across it.
Vec2 parting(const Model& model, const State& state, const Bolt& bolt, const BoltLink& drawn) {
  const Vec2 span = drawn.point_b - drawn.point_a;
  const Vec2 change = change_of_span(model, state, drawn);
  if (!bolt.grouted) return {lengthening(span, change), 0};
  const Vec2 along = direction_in(model, state, bolt, drawn);
  const Vec2 across(-along.y(), along.x());
  return {along.dot(span + change) - bolt.direction.dot(span), across.dot(span + change)};
}

// Gaps from where the anchors are.
void measure(const Model& model, const State& state, const Bolt& bolt, const BoltLink& drawn, LinkElement& link) {
  link.state.gap = parting(model, state, bolt, drawn) - link.start + Vec2(link.pretension_gap, 0) - link.state.plastic;
  link.state.force = answer_of(link.law, link.state.gap, link.carries_nothing()).force;
}

// Rows where the blocks are in `acting`.
void place(const Model& model, const State& acting, const Bolt& bolt, const BoltLink& drawn, LinkElement& link) {
  const auto arm = [&](int block, const Vec2& point) -> Vec2 {
    return local_position(model, acting, block, point) - local_centroid(model, acting, block);
  };
  link.rows = bolt_rows(direction_in(model, acting, bolt, drawn), arm(drawn.block_a, drawn.point_a),
                        arm(drawn.block_b, drawn.point_b));
  if (!bolt.grouted) link.span = (drawn.point_b - drawn.point_a + change_of_span(model, acting, drawn)).norm();
}

// In small kinematics `acting` is the drawing and gaps are summed up from steps, so that nothing is measured again.
void put_in(const Model& model, const State& state, const State& acting, const Bolt& bolt, const BoltLink& drawn,
            LinkElement& link) {
  link.state = {};
  link.start = parting(model, state, bolt, drawn);
  place(model, acting, bolt, drawn, link);
  measure(model, state, bolt, drawn, link);
}

// The forces that the link exerts, as internal forces.
void add(const LinkElement& link, Eigen::VectorXd& force) {
  force.segment<6>(6 * link.block_a).noalias() += link.rows.a.transpose() * link.state.force;
  force.segment<6>(6 * link.block_b).noalias() += link.rows.b.transpose() * link.state.force;
}

void leave_waiting(LinkElement& link) {
  link.state = {};
  link.state.waits = true;
}

void take_over(const LinkElement& before, LinkElement& link) {
  link.start = before.start;
  link.span = before.span;
  link.rows = before.rows;
  link.state = before.state;
}

bool is_same_link(const BoltLink& a, const BoltLink& b) {
  return a.block_a == b.block_a && a.block_b == b.block_b && a.point_a == b.point_a && a.point_b == b.point_b &&
         a.axial_stiffness == b.axial_stiffness && a.shear_stiffness == b.shear_stiffness;
}

bool is_same_bolt(const Bolt& a, const Bolt& b) {
  return a.grouted == b.grouted && a.direction == b.direction && a.pretension == b.pretension &&
         std::ranges::equal(a.links, b.links, is_same_link);
}

}  // namespace

BoltSet::BoltSet(const Model& model, const State& state) {
  for (const Bolt& bolt : model.bolts) {
    first_link_.push_back(links_.size());
    for (const BoltLink& drawn : bolt.links) {
      LinkElement link;
      link.block_a = drawn.block_a;
      link.block_b = drawn.block_b;
      link.law = law_of(bolt, drawn);
      link.rupture_elongation = bolt.rupture_elongation;
      link.pretension_gap = bolt.pretension / drawn.axial_stiffness;
      link.state.waits = bolt.first_stage > 0;
      links_.push_back(link);
    }
  }
  update_geometry(model, state, state);
}

std::vector<std::pair<int, int>> BoltSet::pairs() const {
  std::vector<std::pair<int, int>> pairs;
  for (const LinkElement& link : links_)
    if (!link.state.waits) pairs.emplace_back(link.block_a, link.block_b);
  return pairs;
}

double BoltSet::stored_energy() const {
  double energy = 0;
  for (const LinkElement& link : links_) energy += bolt_energy(link.law, link.state.force);
  return energy;
}

void BoltSet::update_geometry(const Model& model, const State& state, const State& acting) {
  std::size_t next = 0;
  for (const Bolt& bolt : model.bolts)
    for (const BoltLink& drawn : bolt.links) {
      LinkElement& link = links_[next++];
      if (link.state.waits) continue;
      place(model, acting, bolt, drawn, link);
      measure(model, state, bolt, drawn, link);
    }
}

void BoltSet::put_in_those_of(std::size_t stage, const Model& model, const State& state, const State& acting,
                              Eigen::VectorXd& force) {
  for (std::size_t i = 0; i < model.bolts.size(); ++i) {
    const Bolt& bolt = model.bolts[i];
    if (static_cast<std::size_t>(bolt.first_stage) != stage) continue;
    for (std::size_t j = 0; j < bolt.links.size(); ++j) {
      LinkElement& link = links_[first_link_[i] + j];
      put_in(model, state, acting, bolt, bolt.links[j], link);
      add(link, force);
    }
  }
}

void BoltSet::take_out(std::size_t bolt, const Model& model, Eigen::VectorXd& exerted) {
  for (std::size_t j = 0; j < model.bolts[bolt].links.size(); ++j) {
    LinkElement& link = links_[first_link_[bolt] + j];
    if (link.state.waits) continue;
    add(link, exerted);
    leave_waiting(link);
  }
}

void BoltSet::go_on_from(const Model& before_model, const BoltSet& before, const Model& model, std::size_t next,
                         const State& state, const State& acting) {
  for (std::size_t i = 0; i < model.bolts.size(); ++i) {
    const Bolt& bolt = model.bolts[i];
    const auto same = std::ranges::find_if(before_model.bolts, [&](const Bolt& b) { return is_same_bolt(b, bolt); });
    const bool waits = static_cast<std::size_t>(bolt.first_stage) >= next || bolt.withdrawal.is_over_in(next - 1);
    const std::size_t first = same == before_model.bolts.end()
                                  ? 0
                                  : before.first_link_[static_cast<std::size_t>(same - before_model.bolts.begin())];
    const bool is_new = same == before_model.bolts.end() || before.links_[first].state.waits;
    for (std::size_t j = 0; j < bolt.links.size(); ++j) {
      LinkElement& link = links_[first_link_[i] + j];
      if (waits) {
        leave_waiting(link);
      } else if (is_new) {
        put_in(model, state, acting, bolt, bolt.links[j], link);
      } else {
        take_over(before.links_[first + j], link);
      }
    }
  }
}

void BoltSet::add_force(Eigen::VectorXd& force) const {
  for (const LinkElement& link : links_)
    if (!link.state.waits) add(link, force);
}

void BoltSet::accept(const BoltTrials& trials, EnergyAudit& audit) {
  for (std::size_t k = 0; k < links_.size(); ++k) {
    if (links_[k].state.waits) continue;
    const BoltLaw& law = links_[k].law;
    const LinkTrial& trial = trials[k];
    const LinkState before = links_[k].state;
    LinkState& after = links_[k].state;
    after.ruptured = trial.ruptures;
    after.force = trial.force;
    after.gap = trial.ruptures ? trial.gap : elastic_part(law, trial.gap);
    after.plastic += trial.gap - after.gap;
    const double work = (trial.gap - before.gap).dot(before.force + after.force) / 2;
    const double stored = bolt_energy(law, after.force) - bolt_energy(law, before.force);
    const bool breaks = after.ruptured && !before.ruptured;
    const double plastic = breaks ? work - stored : after.force.dot(after.plastic - before.plastic);
    audit.bolt_changed(plastic, work - stored - plastic);
  }
}

}  // namespace dda
