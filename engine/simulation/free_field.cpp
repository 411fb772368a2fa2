#include "engine/simulation/free_field.h"

#include <algorithm>
#include <utility>

#include "engine/contact/block_across.h"
#include "engine/contact/tied_sides.h"
#include "engine/geometry/box.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/branch.h"
#include "engine/terms/viscous_boundary.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double width_of(const Model& model, int block) {
  const Box box = bounding_box(model.blocks[at(block)].shape);
  return box.upper.x() - box.lower.x();
}

// Calls act(edge, outward, contact) for the edges of all sides and their contacts.
template <typename Contacts, typename Act>
void for_each_edge(const Model& model, Contacts& contacts, Act act) {
  std::size_t next = 0;
  for (const FreeFieldSide& side : model.free_field_sides)
    for (const int index : side.viscous_edges) act(model.viscous_edges[at(index)], side.outward, contacts[next++]);
}

}  // namespace

FreeField::FreeField(const Model& model, const ContactSet& contacts, const State& state)
    : FreeField(model, state, make_free_field_columns(model, contacts)) {}

FreeField::FreeField(const Model& model, const State& state, FreeFieldColumns&& columns)
    : contacts_(columns.blocks.size()), columns_(std::move(columns.model)) {
  for_each_edge(model, contacts_,
                [&, next = std::size_t{0}](const ViscousEdge& edge, double, Contact& contact) mutable {
                  contact.block = edge.block;
                  contact.ties = columns.ties[next];
                  contact.column_block = columns.blocks[next++];
                  contact.wider = width_of(model, contact.block) / width_of(columns_.model(), contact.column_block);
                });
  read_columns();
  update_geometry(model, state, 0);
}

void FreeField::go_on_from(const FreeField& before) {
  contacts_ = before.contacts_;
  time_old_ = before.time_old_;
  time_ = before.time_;
  dda::go_on_from(before.columns_, columns_);
}

void FreeField::read_columns() {
  for (Contact& contact : contacts_) {
    contact.old = contact.now;
    contact.now = motion_of(contact);
  }
}

// The ties hold each side of the block as the ground beyond it would.
FreeField::Motion FreeField::motion_of(const Contact& contact) const {
  Motion motion;
  motion.velocity = columns_.state().velocity[at(contact.column_block)];
  for (const std::size_t index : {contact.ties, contact.ties + 1}) {
    const SupportElement& tie = columns_.system().supports[index];
    motion.force -= tie.stiffness * tie.gap;
    motion.force_rate -= tie.stiffness * (tie.rows * motion.velocity);
  }
  if (const auto sides = tied_sides(columns_.model(), contact.column_block, Vec2::UnitX()))
    add_on_strains(contact, *sides, motion);
  return motion;
}

// What a projected joint does to the strains of a block beside it, softness times length times what it carries beyond
// the block's own traction: nothing, but for what the column gives way between its sides.
void FreeField::add_on_strains(const Contact& contact, const TiedSides& sides, Motion& motion) const {
  const Mat3 elasticity = elasticity_matrix(columns_.model().material_of(contact.column_block));
  const Mat23 rows = traction_rows(Vec2::UnitX());
  const auto on_strains = [&](const Vec2& force, const Vec3& stress) -> Vec3 {
    const Vec2 beyond = force - sides.length * (rows * stress);
    return -contact.wider * sides.softness / 2 * (elasticity * (rows.transpose() * beyond));
  };
  motion.on_strains = on_strains(motion.force, columns_.state().stress[at(contact.column_block)]);
  motion.on_strains_rate = on_strains(motion.force_rate, elasticity * motion.velocity.tail<3>());
}

// A static stage that has come to rest ends before its time: what was reached last says nothing of where a step begins.
Status FreeField::advance_to(double time, double dt) {
  if (time_ >= time) return Status::ok;
  const double middle = time - dt / 2;  // the clocks of both may differ by round-off
  const bool is_behind = columns_.state().time < middle;
  const bool settles = is_behind && columns_.system().stage().integrator.is_static;
  const std::vector<Vec6> before = settles ? columns_.state().displacement : std::vector<Vec6>();
  if (is_behind)
    if (const Status status = columns_.step(); status != Status::ok) return status;
  read_columns();
  if (settles) keep_pace(before, dt);
  time_old_ = time - dt;
  time_ = time;
  return Status::ok;
}

// Static steps leave blocks at rest, and the side's dashpots act on the velocity that the step of the model ends with
// before it is taken out, 2 d/dt. Where the column had none the side was held back by them while the ground beyond it
// settled: rock whose joints slide or gape on the way came to rest otherwise.
void FreeField::keep_pace(const std::vector<Vec6>& before, double dt) {
  for (Contact& contact : contacts_) {
    const std::size_t block = at(contact.column_block);
    contact.now.velocity = 2 / dt * (columns_.state().displacement[block] - before[block]);
    contact.old.velocity = contact.now.velocity;  // a part of the step has the same
  }
}

// A column is at rest between stages, if it has settled.
bool FreeField::stand_still() {
  bool any = false;
  for (Contact& contact : contacts_) {
    const Vec6& velocity = columns_.state().velocity[at(contact.column_block)];
    any = any || contact.now.velocity != velocity;
    contact.now.velocity = velocity;
  }
  return any;
}

bool FreeField::stands_still_until(double time) const { return columns_.finished() || columns_.state().time >= time; }

bool FreeField::begin_stage(const Model& model, const State& state, std::size_t stage) {
  bool any = false;
  for_each_edge(model, contacts_, [&](const ViscousEdge& edge, double, Contact& contact) {
    if (at(edge.first_stage) != stage) return;
    contact.force_before = contact.now.force;
    contact.on_strains_before = contact.now.on_strains;
    any = true;
  });
  if (any) update_geometry(model, state, stage);
  return stand_still() || any;
}

void FreeField::update_geometry(const Model& model, const State& state, std::size_t stage) {
  for_each_edge(model, contacts_, [&](const ViscousEdge& edge, double outward, Contact& contact) {
    if (at(edge.first_stage) <= stage) place(model, state, edge, outward, contact);
  });
}

void FreeField::place(const Model& model, const State& state, const ViscousEdge& edge, double outward,
                      Contact& contact) {
  const auto offset = [](const Model& own, const State& now, int block, const Vec2& point) -> Vec2 {
    return local_position(own, now, block, point) - local_centroid(own, now, block);
  };
  const Vec2 from = offset(model, state, edge.block, edge.from);
  const Vec2 to = offset(model, state, edge.block, edge.to);
  // The point of the column's block that lies in it as `point` does in the model's: blocks that shear on vertical
  // joints which give way move along them as well.
  const double own_centroid = model.blocks[at(edge.block)].moments.centroid.x();
  const double column_centroid = columns_.model().blocks[at(contact.column_block)].moments.centroid.x();
  const auto in_column = [&](const Vec2& point) {
    return offset(columns_.model(), columns_.state(), contact.column_block,
                  {column_centroid + point.x() - own_centroid, point.y()});
  };
  contact.dashpots =
      viscous_coupling(from, to, in_column(edge.from), in_column(edge.to), edge.normal_impedance, edge.shear_impedance);
  contact.middle = outward * displacement_rows((from + to) / 2).transpose();
  contact.acts = true;
}

void FreeField::add_loads_at(double time, double stiffness_damping, Eigen::VectorXd& force) const {
  const double passed = time_ > time_old_ ? (time - time_old_) / (time_ - time_old_) : 1;
  const double share = std::clamp(passed, 0.0, 1.0);
  for (const Contact& contact : contacts_) {
    if (!contact.acts) continue;
    const Vec6 velocity = (1 - share) * contact.old.velocity + share * contact.now.velocity;
    const auto now = [&](auto part) { return ((1 - share) * contact.old.*part + share * contact.now.*part).eval(); };
    const Vec2 tied = now(&Motion::force) - contact.force_before;
    const Vec2 rate = now(&Motion::force_rate);
    auto own = force.segment<6>(6 * contact.block);
    own.noalias() += contact.dashpots * velocity;
    own.noalias() += contact.middle * (tied + stiffness_damping * rate);
    own.tail<3>() += now(&Motion::on_strains) - contact.on_strains_before;
    own.tail<3>() += stiffness_damping * now(&Motion::on_strains_rate);
  }
}

}  // namespace dda
