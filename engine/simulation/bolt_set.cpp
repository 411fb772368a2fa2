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

BoltAnswer answer_of(const BoltLaw& law, const Vec2& gap, bool ruptured) {
  return ruptured ? BoltAnswer{Vec2::Zero(), Vec2::Zero()} : bolt_answer(law, gap);
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

}  // namespace

BoltSet::BoltSet(const Model& model, const State& state) {
  for (std::size_t i = 0; i < model.bolts.size(); ++i) {
    const Bolt& bolt = model.bolts[i];
    first_link_.push_back(links_.size());
    for (std::size_t j = 0; j < bolt.links.size(); ++j) {
      Link link;
      link.bolt = static_cast<int>(i);
      link.number = static_cast<int>(j);
      link.block_a = bolt.links[j].block_a;
      link.block_b = bolt.links[j].block_b;
      link.law = law_of(bolt, bolt.links[j]);
      link.rupture_elongation = bolt.rupture_elongation;
      link.pretension_gap = bolt.pretension / bolt.links[j].axial_stiffness;
      links_.push_back(link);
    }
  }
  update_geometry(model, state);
}

std::vector<std::pair<int, int>> BoltSet::pairs() const {
  std::vector<std::pair<int, int>> pairs;
  for (const Link& link : links_) pairs.emplace_back(link.block_a, link.block_b);
  return pairs;
}

double BoltSet::stored_energy() const {
  double energy = 0;
  for (const Link& link : links_) energy += bolt_energy(link.law, link.state.force);
  return energy;
}

// Rows, and gaps from where the anchors are.
void BoltSet::place(const Model& model, const State& state, Link& link) {
  const Bolt& bolt = model.bolts[static_cast<std::size_t>(link.bolt)];
  const BoltLink& drawn = bolt.links[static_cast<std::size_t>(link.number)];
  const Vec2 a = current_position(model, state, link.block_a, drawn.point_a);
  const Vec2 b = current_position(model, state, link.block_b, drawn.point_b);
  const Vec2 span = drawn.point_b - drawn.point_a;
  const Vec2 change = point_displacement(model, state, link.block_b, drawn.point_b) -
                      point_displacement(model, state, link.block_a, drawn.point_a);
  const Vec2 along =
      bolt.grouted ? turned_with_blocks(state, drawn, bolt.direction) : Vec2((span + change).normalized());
  const Vec2 across(-along.y(), along.x());
  link.rows = bolt_rows(along, a - current_centroid(model, state, link.block_a),
                        b - current_centroid(model, state, link.block_b));
  Vec2 total(lengthening(span, change), 0);
  if (bolt.grouted) total = Vec2(along.dot(span + change) - bolt.direction.dot(span), across.dot(span + change));
  link.state.gap = total + Vec2(link.pretension_gap, 0) - link.state.plastic;
  link.state.force = answer_of(link.law, link.state.gap, link.state.ruptured).force;
}

void BoltSet::update_geometry(const Model& model, const State& state) {
  for (Link& link : links_) place(model, state, link);
}

void BoltSet::add_force(Eigen::VectorXd& force) const {
  for (const Link& link : links_) {
    force.segment<6>(6 * link.block_a).noalias() += link.rows.a.transpose() * link.state.force;
    force.segment<6>(6 * link.block_b).noalias() += link.rows.b.transpose() * link.state.force;
  }
}

void BoltSet::add_stiffness(double factor, BlockMatrix& matrix) const {
  for (const Link& link : links_) {
    const Vec2 stiffness = factor * link.matrix_rows.cwiseProduct(link.law.stiffness);
    const Eigen::Matrix<double, 6, 2> weighted_a = link.rows.a.transpose() * stiffness.asDiagonal();
    const Eigen::Matrix<double, 6, 2> weighted_b = link.rows.b.transpose() * stiffness.asDiagonal();
    matrix.diagonal(link.block_a) += weighted_a * link.rows.a;
    matrix.diagonal(link.block_b) += weighted_b * link.rows.b;
    matrix.add_coupling(link.block_b, link.block_a, weighted_b * link.rows.a);
  }
}

void BoltSet::respond(Link& link) {
  const BoltAnswer answer = answer_of(link.law, link.gap, link.ruptures);
  link.force = answer.force;
  link.active = answer.active;
}

void BoltSet::start_trials() {
  for (Link& link : links_) {
    link.gap = link.state.gap;
    link.ruptures = link.state.ruptured;
    respond(link);
  }
}

bool BoltSet::active_rows_changed() {
  bool changed = false;
  for (Link& link : links_) {
    if (link.matrix_rows == link.active) continue;
    link.matrix_rows = link.active;
    changed = true;
  }
  return changed;
}

void BoltSet::add_rhs(double factor, Eigen::VectorXd& rhs) const {
  for (const Link& link : links_) {
    const Vec2 reached = link.gap - link.state.gap;
    const Vec2 constant =
        link.force - link.matrix_rows.cwiseProduct(link.law.stiffness).cwiseProduct(reached) - link.state.force;
    rhs.segment<6>(6 * link.block_a).noalias() -= factor * link.rows.a.transpose() * constant;
    rhs.segment<6>(6 * link.block_b).noalias() -= factor * link.rows.b.transpose() * constant;
  }
}

void BoltSet::aim(const Eigen::VectorXd& newton_step) {
  for (Link& link : links_)
    link.direction =
        link.rows.a * newton_step.segment<6>(6 * link.block_a) + link.rows.b * newton_step.segment<6>(6 * link.block_b);
}

double BoltSet::mismatch_of_whole_step() const {
  double mismatch = 0;
  for (const Link& link : links_) {
    const Vec2 after = answer_of(link.law, link.gap + link.direction, link.ruptures).force;
    const Vec2 expected = link.active.cwiseProduct(link.law.stiffness).cwiseProduct(link.direction);
    mismatch = std::max(mismatch, (after - link.force - expected).cwiseAbs().maxCoeff());
  }
  return mismatch;
}

double BoltSet::largest_force() const {
  double largest = 0;
  for (const Link& link : links_) largest = std::max(largest, link.force.cwiseAbs().maxCoeff());
  return largest;
}

double BoltSet::active_curvature() const {
  double curvature = 0;
  for (const Link& link : links_)
    curvature += link.direction.dot(link.active.cwiseProduct(link.law.stiffness).cwiseProduct(link.direction));
  return curvature;
}

double BoltSet::active_slope() const {
  double slope = 0;
  for (const Link& link : links_) {
    const Vec2 along = link.active.cwiseProduct(link.law.stiffness).cwiseProduct(link.direction);
    slope += along.dot(link.gap - link.state.gap) + link.direction.dot(link.state.force);
  }
  return slope;
}

double BoltSet::force_along(double t) const {
  double along = 0;
  for (const Link& link : links_)
    along += link.direction.dot(answer_of(link.law, link.gap + t * link.direction, link.ruptures).force);
  return along;
}

void BoltSet::follow_trials(double share) {
  for (Link& link : links_) {
    link.gap += share * link.direction;
    respond(link);
  }
}

bool BoltSet::break_links() {
  bool broke = false;
  for (Link& link : links_) {
    const double elongation = link.gap(0) + link.state.plastic(0) - link.pretension_gap;
    if (link.ruptures || elongation <= link.rupture_elongation) continue;
    link.ruptures = broke = true;
    respond(link);
  }
  return broke;
}

void BoltSet::accept(EnergyAudit& audit) {
  for (Link& link : links_) {
    const LinkState before = link.state;
    LinkState& after = link.state;
    after.ruptured = link.ruptures;
    after.force = link.force;
    after.gap = link.ruptures ? link.gap : elastic_part(link.law, link.gap);
    after.plastic += link.gap - after.gap;
    const double work = (link.gap - before.gap).dot(before.force + after.force) / 2;
    const double stored = bolt_energy(link.law, after.force) - bolt_energy(link.law, before.force);
    const bool breaks = after.ruptured && !before.ruptured;
    const double plastic = breaks ? work - stored : after.force.dot(after.plastic - before.plastic);
    audit.bolt_changed(plastic, work - stored - plastic);
  }
}

}  // namespace dda
