#include "engine/simulation/snapshot.h"

#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/model/rock_change.h"
#include "engine/simulation/archive.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/excavation.h"
#include "engine/simulation/explicit_step.h"
#include "engine/simulation/free_field.h"
#include "engine/simulation/general_step.h"
#include "engine/simulation/linear_step.h"
#include "engine/simulation/rock_of_stage.h"

namespace dda {
namespace {

constexpr std::uint64_t kind = 0x3532'4e53'4144'44ULL;  // "DDASN25", read as a little-endian number

// What the numbers of a snapshot can be compared with.
template <typename AnyArchive>
void check_parts(const BlockSystem& s, bool follows_contacts, AnyArchive& archive) {
  archive.same(s.model.stages.size(), "stages");
  if (!follows_contacts) archive.same(s.contacts.interfaces.size(), "interfaces");
  archive.same(s.supports.size(), "supports");
  archive.same(s.model.held_blocks.size(), "held blocks");
  archive.same(s.external.number_of_loads(), "loads");
  archive.same(s.damping.size(), "blocks with viscous edges");
  archive.same(s.model.free_field_sides.size(), "free-field sides");
}

ArchivedCounts counts_of(const Model& model) {
  ArchivedCounts counts{model.blocks.size(), model.joints.size(), 0, model.stages.size()};
  for (const Block& block : model.blocks) {
    counts.vertices += block.shape.outer.size();
    for (const Ring& hole : block.shape.holes) counts.vertices += hole.size();
  }
  return counts;
}

void take_rock_at_start(Model& model) {
  model.materials = std::vector(materials_in(model, 0));
  model.joints = std::vector(joints_in(model, 0));
}

std::vector<std::pair<int, int>> touching_blocks(const std::vector<Interface>& interfaces) {
  std::vector<std::pair<int, int>> pairs;
  for (const Interface& interface : interfaces) pairs.emplace_back(interface.block_a, interface.block_b);
  return pairs;
}

std::vector<std::pair<int, int>> touching_blocks(const InterfaceElements& elements) {
  std::vector<std::pair<int, int>> pairs;
  InterfaceElement room;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const InterfaceElement& element = elements.read(i, room);
    pairs.emplace_back(element.block_a, element.block_b);
  }
  return pairs;
}

// The stage under way must be that of the saved run, and must not be over.
void check_place_in_run(const BlockSystem& s, double saved_dt) {
  const std::size_t stages = s.model.stages.size();
  if (s.clock.in_force() >= stages)
    throw InputError("", "checkpoint", fmt::format("of stage {}", s.clock.stage + 1),
                     fmt::format("one of the {} stages of this scene", stages));
  const Stage& stage = s.stage_in_force();
  if (saved_dt != stage.dt)
    throw InputError("", "checkpoint", fmt::format("of steps of {} s", saved_dt),
                     fmt::format("the {} s of stage \"{}\"", stage.dt, stage.name));
  if (s.clock.begun && !stage.paces_itself() && s.clock.step >= stage.steps())
    throw InputError("", "checkpoint", fmt::format("at step {} of a stage", s.clock.step),
                     fmt::format("less than the {} steps of stage \"{}\"", stage.steps(), stage.name));
}

}  // namespace

template <typename Self, typename Archive>
void Simulation::visit(Self& self, Archive& archive) {
  auto& [system, general, linear, explicit_steps, message, pace, results, stability_limits, in_situ_force, memory,
         watch] = self;
  // The message is of the last step, and in-situ forces are the drawing's.
  archive(*system, *general, *linear, *explicit_steps, pace, results);
}

std::vector<std::byte> Simulation::save() const {
  MemoryWriter writer;
  const double dt = system_->stage_in_force().dt;
  const Counters counts = counters();
  writer(kind, dt);
  writer(system_->clock);
  check_parts(*system_, follows_contacts(), writer);
  visit(*this, writer);
  for (const CounterField& field : counter_fields) writer(counts.*field.value);
  return writer.take();
}

void Simulation::restore(State state, std::span<const std::byte> snapshot) {
  MemoryReader reader(snapshot);
  BlockSystem& s = *system_;
  reader.check_against(counts_of(s.model));
  std::uint64_t saved_kind = 0;
  double dt = 0;
  reader(saved_kind);
  if (saved_kind != kind) throw InputError("", "checkpoint", "of another version or kind", "one of this program");
  reader(dt);
  take_rock_at_start(s.model);
  draw_all(s, general_);
  reader(s.clock);
  leave_out_absent(s, *general_);
  take_rock_in_force(s);
  s.external.begin_stage(s.model, s.clock.in_force());
  check_parts(s, follows_contacts(), reader);
  check_place_in_run(s, dt);
  s.state = std::move(state);
  const Stage& stage = s.stage_in_force();
  set_strain_inertia(stage, s.terms);
  s.plan = make_plan(s.model, s.clock.in_force(), s.contacts, 0, {});
  const auto drawn_pairs = touching_blocks(s.contacts.interfaces);
  visit(*this, reader);
  const auto pairs = touching_blocks(s.contacts.interfaces);
  reader.expect(touching_blocks(s.contacts.elements) == pairs && (follows_contacts() || pairs == drawn_pairs));
  reader.expect(s.excavated.released.fit(s.model));
  for (const CounterField& field : counter_fields) reader(s.costs.counters.*field.value);
  reader.expect_end();
  stage_step().set_up(general_->pattern());
}

void MemoryWriter::run(const Simulation& simulation) {
  const std::vector<std::byte> bytes = simulation.save();
  visit_memory(simulation.state(), [this](const void* memory, std::size_t count) { raw(memory, count); });
  number(bytes.size());
  raw(bytes.data(), bytes.size());
}

void MemoryReader::run(Simulation& simulation) {
  State state = simulation.state();
  visit_memory(state, [this](void* memory, std::size_t count) { raw(memory, count); });
  const std::size_t size = number();
  if (size > bytes_.size()) throw InputError("", "checkpoint", "cut off", "the whole state of a simulation");
  simulation.restore(std::move(state), bytes_.first(size));
  bytes_ = bytes_.subspan(size);
}

std::vector<std::byte> save(const Simulation& simulation) { return simulation.save(); }

void restore(Simulation& simulation, State state, std::span<const std::byte> snapshot) {
  simulation.restore(std::move(state), snapshot);
}

}  // namespace dda
