#include "engine/simulation/snapshot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>

#include "engine/core/error.h"
#include "engine/simulation/free_field.h"
#include "engine/simulation/step_coefficients.h"
#include "engine/simulation/system_matrix.h"

namespace dda {
namespace {

constexpr std::uint64_t magic = 0x3950414e53414444;  // "DDASNAP9", read as a little-endian number
constexpr std::size_t most_entries = 1'000'000'000;  // of any list: more is a damaged file

class Writer {
 public:
  void raw(const void* from, std::size_t count) {
    if (count == 0) return;
    const std::size_t end = bytes_.size();
    bytes_.resize(end + count);
    std::memcpy(bytes_.data() + end, from, count);
  }
  // The number of things of one kind, which restoring compares.
  void same(std::size_t count, const char* /*what*/) { number(count); }
  template <typename Number>
  void number(const Number& value) {
    static_assert(std::is_trivially_copyable_v<Number>);
    raw(&value, sizeof value);
  }
  void vector(const Eigen::VectorXd& values) {
    number(values.size());
    raw(values.data(), static_cast<std::size_t>(values.size()) * sizeof(double));
  }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}
  void raw(void* to, std::size_t count) {
    if (count > bytes_.size()) throw InputError("", "checkpoint", "cut off", "the whole state of a simulation");
    if (count > 0) std::memcpy(to, bytes_.data(), count);
    bytes_ = bytes_.subspan(count);
  }
  void same(std::size_t count, const char* what) {
    std::size_t saved = 0;
    number(saved);
    if (saved != count)
      throw InputError("", "checkpoint", fmt::format("of a scene with {} {}", saved, what),
                       fmt::format("one with {} {} as this scene has", count, what));
  }
  template <typename Number>
  void number(Number& value) {
    static_assert(std::is_trivially_copyable_v<Number>);
    raw(&value, sizeof value);
  }
  void vector(Eigen::VectorXd& values) {
    Eigen::Index size = 0;
    number(size);
    if (size != 0 && size != values.size() && values.size() != 0)
      throw InputError("", "checkpoint", fmt::format("of {} unknowns", size), fmt::format("{}", values.size()));
    if (size < 0 || static_cast<std::size_t>(size) > bytes_.size() / sizeof(double))
      throw InputError("", "checkpoint", "cut off", "the whole state of a simulation");
    values.resize(size);
    raw(values.data(), static_cast<std::size_t>(size) * sizeof(double));
  }
  // The bytes of a part that begins with their number.
  std::span<const std::byte> part() {
    std::size_t size = 0;
    number(size);
    if (size > bytes_.size()) throw InputError("", "checkpoint", "cut off", "the whole state of a simulation");
    const std::span<const std::byte> first = bytes_.first(size);
    bytes_ = bytes_.subspan(size);
    return first;
  }
  void expect_end() const {
    if (!bytes_.empty()) throw InputError("", "checkpoint", "too long", "the state of one simulation");
  }

 private:
  std::span<const std::byte> bytes_;
};

// Eigen's fixed-size matrices, by their numbers.
template <typename Archive, typename... Matrices>
void matrices(Archive& archive, Matrices&... matrix) {
  (archive.raw(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(double)), ...);
}

template <typename Archive, typename Element>
void geometry(Archive& archive, Element& element) {
  matrices(archive, element.rows_a, element.rows_b, element.stress_rows_a, element.stress_rows_b, element.strain_rows_a,
           element.strain_rows_b);
}

template <typename Archive, typename AnyState>
void contact_state(Archive& archive, AnyState& state) {
  auto& [gap, force, status, broken, slip, residual, dilation, seat] = state;
  matrices(archive, gap, force);
  archive.number(status);
  archive.number(broken);
  archive.number(slip);
  archive.number(residual);
  archive.number(dilation);
  archive.number(seat);
}

}  // namespace

struct SnapshotAccess {
  // Stage under way; the last one when the run is over.
  static const Stage& stage_in_force(const Simulation& s) {
    return s.model_.stages[std::min(s.stage_, s.model_.stages.size() - 1)];
  }

  template <typename AnySimulation, typename Archive>
  static void place_in_run(AnySimulation& s, Archive& archive) {
    archive.same(s.model_.stages.size(), "stages");
    if (!s.moving_) archive.same(s.contacts_.interfaces.size(), "interfaces");
    archive.same(s.supports_.size(), "supports");
    archive.same(s.model_.held_blocks.size(), "held blocks");
    archive.same(s.bolts_.links_.size(), "links of bolts");
    archive.same(s.external_.loads_.size(), "loads");
    archive.same(s.damping_.size(), "blocks with viscous edges");
    archive.same(s.model_.free_field_sides.size(), "free-field sides");
    archive.number(s.stage_);
    archive.number(s.step_in_stage_);
    archive.number(s.stage_start_);
  }

  static void check_place(const Simulation& s, double saved_dt) {
    if (s.stage_ > s.model_.stages.size())
      throw InputError("", "checkpoint", fmt::format("of stage {}", s.stage_ + 1),
                       fmt::format("one of the {} stages of this scene", s.model_.stages.size()));
    if (saved_dt != stage_in_force(s).dt)
      throw InputError("", "checkpoint", fmt::format("of steps of {} s", saved_dt),
                       fmt::format("the {} s of stage \"{}\"", stage_in_force(s).dt, stage_in_force(s).name));
    if (s.stage_ < s.model_.stages.size() && s.step_in_stage_ >= s.steps_in_stage())
      throw InputError("", "checkpoint", fmt::format("at step {} of a stage", s.step_in_stage_),
                       fmt::format("less than the {} steps of stage \"{}\"", s.steps_in_stage(), s.stage().name));
  }

  // A list whose length a restored simulation takes over.
  template <typename Archive, typename List>
  static void resize(Archive& archive, List& list) {
    std::size_t size = list.size();
    archive.number(size);
    if constexpr (!std::is_const_v<List>) {
      if (size > most_entries) throw InputError("", "checkpoint", "damaged", "the state of a simulation");
      list.resize(size);
    }
  }

  // Which contacts there are, where blocks move against each other.
  template <typename AnySimulation, typename Archive>
  static void contact_list(AnySimulation& s, Archive& archive) {
    auto& moving = *s.moving_;
    archive.number(moving.stretches_);
    resize(archive, moving.known_);
    for (auto& contact : moving.known_) {
      auto& [edge_block, vertex_block, edge, vertex, normal, gap] = contact;
      for (auto* number : {&edge_block, &vertex_block, &edge, &vertex}) archive.number(*number);
      matrices(archive, normal);
      archive.number(gap);
    }
    for (auto& box : moving.search_.grown_) matrices(archive, box.lower, box.upper);
    resize(archive, moving.search_.pairs_);
    for (auto& pair : moving.search_.pairs_) {
      archive.number(pair.first);
      archive.number(pair.second);
    }
    resize(archive, s.contacts_.interfaces);
    resize(archive, s.contacts_.elements);
    resize(archive, s.contacts_.strengths);
    resize(archive, s.contacts_.states);
    for (std::size_t i = 0; i < s.contacts_.interfaces.size(); ++i) {
      auto& interface = s.contacts_.interfaces[i];
      auto& element = s.contacts_.elements[i];
      matrices(archive, interface.from, interface.to, interface.normal, element.stiffness, element.dashpot);
      for (auto* number :
           {&interface.block_a, &interface.block_b, &interface.joint, &element.block_a, &element.block_b})
        archive.number(*number);
      archive.number(interface.length);
      archive.number(element.length);
      archive.number(s.contacts_.strengths[i]);
    }
    if constexpr (!std::is_const_v<AnySimulation>) s.matrix_ = s.make_moving_matrix();
  }

  template <typename AnySimulation, typename Archive>
  static void contacts(AnySimulation& s, bool moves, Archive& archive) {
    if (!moves && !s.contacts_.can_change && s.bolts_.empty()) return;
    if (s.moving_) contact_list(s, archive);
    resize(archive, s.matrix_rows_);
    for (auto& rows : s.matrix_rows_) matrices(archive, rows);
    for (std::size_t i = 0; i < s.contacts_.elements.size(); ++i) {
      auto& element = s.contacts_.elements[i];
      InterfaceLaw law = element.law;
      archive.number(law);
      if constexpr (!std::is_const_v<AnySimulation>) {
        if (s.moving_) {
          element.law = law;
        } else if (law != element.law) {
          element = make_element(s.model_, s.contacts_.interfaces[i], law);
          set_geometry(s.model_, reference_frame(s.model_, s.contacts_.interfaces[i]), element);
        }
      }
      if (moves) geometry(archive, element);
      contact_state(archive, s.contacts_.states[i]);
    }
  }

  // What follows the blocks in finite kinematics. It is that of the latest step's start, so not to be had from State.
  template <typename AnySimulation, typename Archive>
  static void moved_geometry(AnySimulation& s, Archive& archive) {
    archive.number(s.moved_);
    for (auto& turned : s.turned_) matrices(archive, turned);
    for (auto& inertia : s.terms_.inertia) matrices(archive, inertia.squares);
    for (auto& area : s.terms_.area) archive.number(area);
    for (auto& displacement : s.contact_range_.checked_displacement_) matrices(archive, displacement);
    for (auto& deformation : s.contact_range_.checked_deformation_) matrices(archive, deformation);
  }

  static void columns(const Simulation& columns, Writer& writer) {
    const std::vector<std::byte> bytes = save(columns);
    visit_memory(columns.state_, [&](const void* memory, std::size_t count) { writer.raw(memory, count); });
    writer.number(bytes.size());
    writer.raw(bytes.data(), bytes.size());
  }

  static void columns(Simulation& columns, Reader& reader) {
    State state = columns.state_;
    visit_memory(state, [&](void* memory, std::size_t count) { reader.raw(memory, count); });
    restore(columns, std::move(state), Reader(reader.part()));
  }

  // The columns' run, and what the model last knew of it.
  template <typename AnyFreeField, typename Archive>
  static void free_field(AnyFreeField& field, Archive& archive) {
    columns(field.columns_, archive);
    archive.number(field.time_old_);
    archive.number(field.time_);
    for (auto& contact : field.contacts_)
      matrices(archive, contact.dashpots, contact.middle, contact.force_before, contact.old.velocity, contact.old.force,
               contact.now.velocity, contact.now.force);
  }

  template <typename AnySimulation, typename Archive>
  static void the_rest(AnySimulation& s, Archive& archive) {
    const bool moves = s.geometry_moves();
    contacts(s, moves, archive);
    if (moves) moved_geometry(s, archive);
    for (auto& [block, matrix] : s.damping_) matrices(archive, matrix);
    for (auto& load : s.external_.loads_) matrices(archive, load.force);
    if constexpr (std::is_const_v<AnySimulation>) {
      if (s.free_field_) free_field(std::as_const(*s.free_field_), archive);
    } else {
      if (s.free_field_) free_field(*s.free_field_, archive);
    }
    for (auto& reaction : s.external_.reactions_) matrices(archive, reaction.force);
    for (auto& support : s.supports_)
      matrices(archive, support.offset, support.rows, support.stiffness, support.gap, support.prescribed);
    for (auto& link : s.bolts_.links_) {
      auto& [gap, plastic, force, ruptured] = link.state;
      matrices(archive, link.rows.a, link.rows.b, gap, plastic, force, link.matrix_rows);
      archive.number(ruptured);
    }
    for (auto* vector : {&s.load_old_, &s.internal_old_, &s.increment_, &s.momentum_, &s.inertia_force_,
                         &s.elastic_force_, &s.internal_at_rest_})
      archive.vector(*vector);
    archive.number(s.energy_offset_);
    for (auto& share : s.static_out_of_balance_) archive.number(share);
    archive.number(s.audit_.ledger_);
    archive.number(s.audit_.replaced_);
    archive.number(s.deepest_);
    archive.number(s.plan_.chi);
    archive.number(s.plan_.solver);
  }

  static std::vector<std::byte> save(const Simulation& s) {
    Writer writer;
    writer.number(magic);
    writer.number(stage_in_force(s).dt);
    place_in_run(s, writer);
    the_rest(s, writer);
    writer.number(s.counters());
    return writer.take();
  }

  static void restore(Simulation& s, State state, Reader reader) {
    std::uint64_t first = 0;
    reader.number(first);
    if (first != magic) throw InputError("", "checkpoint", "of another version or kind", "one of this program");
    double dt = 0;
    reader.number(dt);
    place_in_run(s, reader);
    check_place(s, dt);
    s.state_ = std::move(state);
    const Stage& stage = stage_in_force(s);
    set_strain_inertia(stage, s.terms_);
    s.plan_ = make_plan(s.model_, stage, s.contacts_, s.matrix_.couplings(), 0);
    the_rest(s, reader);
    reader.number(s.counters_);
    reader.expect_end();
    make_solver_ready(s, stage);
  }

  static void make_solver_ready(Simulation& s, const Stage& stage) {
    s.solver_ = make_solver(s.plan_.solver, s.plan_.chi);
    s.solver_->analyze(s.matrix_);
    ++s.counters_.analyses;
    s.coefficients_ = step_coefficients(stage.integrator, stage.dt);
    s.matrix_is_current_ = false;
    if (s.plan_.contacts_can_change) s.newton_.resize(s.matrix_.unknowns());
    s.linear_.reset();
    if (!s.plan_.linear) return;
    s.linear_.emplace(make_linear_operators(s.model_, stage, s.terms_, s.contacts_, s.supports_));
    if (s.plan_.loads) s.external_.sharpen(load_sharpening(s.model_, stage, s.contacts_), stage.dt);
  }
};

std::vector<std::byte> save(const Simulation& simulation) { return SnapshotAccess::save(simulation); }

void restore(Simulation& simulation, State state, std::span<const std::byte> snapshot) {
  SnapshotAccess::restore(simulation, std::move(state), Reader(snapshot));
}

}  // namespace dda
