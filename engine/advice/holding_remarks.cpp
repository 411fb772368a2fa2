#include "engine/advice/holding_remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>

#include "engine/advice/acting_on_body.h"
#include "engine/advice/block_named.h"
#include "engine/core/disjoint_sets.h"

namespace dda {
namespace {

using Blocks = std::vector<int>;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// What touches where blocks come in is not among the contacts that a run begins with.
std::vector<Interface> drawn_interfaces(const Model& model, const ContactSet& contacts) {
  return model.adds_blocks() ? find_interfaces(model) : contacts.interfaces;
}

bool is_there(const std::vector<bool>& absent, int block) { return absent.empty() || !absent[at(block)]; }

// Sets of blocks that touch or are bolted together in a stage.
class Bodies {
 public:
  Bodies(const Model& model, const std::vector<Interface>& interfaces, std::size_t stage)
      : absent_(model.absent_in(stage)), sets_(model.blocks.size()) {
    for (const Interface& interface : interfaces) join(interface.block_a, interface.block_b);
    for (const Bolt& bolt : model.bolts)
      for (const BoltLink& link : bolt.links)
        if (at(bolt.first_stage) <= stage) join(link.block_a, link.block_b);
    for (const Lining& lining : model.linings)
      if (at(lining.first_stage) <= stage)
        for (std::size_t i = 0; i < lining.elements(); ++i) join(lining.start_of(i).block, lining.end_of(i).block);
  }

  // Those that touch nothing that touches ... something held, by their first blocks.
  std::vector<Blocks> not_held(const std::set<int>& held, int blocks) {
    std::set<int> held_bodies;
    for (const int block : held) held_bodies.insert(sets_.root(block));
    std::map<int, Blocks> loose;
    for (int i = 0; i < blocks; ++i)
      if (is_there(absent_, i) && !held_bodies.contains(sets_.root(i))) loose[sets_.root(i)].push_back(i);
    std::vector<Blocks> bodies;
    for (auto& [body, members] : loose) bodies.push_back(std::move(members));
    return bodies;
  }

 private:
  void join(int a, int b) {
    if (is_there(absent_, a) && is_there(absent_, b)) sets_.join(a, b);
  }

  std::vector<bool> absent_;
  DisjointSets sets_;
};

std::set<int> held_blocks_of(const Model& model) {
  std::set<int> held;
  for (const PointSupport& support : model.supports)
    if (!support.partner) held.insert(support.block);
  for (const HeldBlock& block : model.held_blocks) held.insert(block.block);
  return held;
}

constexpr const char* how_to_hold =
    "hold it by supports, of which two points are enough: one in x and y, the other across the way to it";

// Blocks of bodies that nothing holds, by what becomes of them.
struct NotHeld {
  Blocks falling, resting, turning;
};

NotHeld by_fate(const Model& model, std::size_t stage, const std::vector<Blocks>& bodies) {
  NotHeld all;
  const std::vector<ActingOnBody> acting = acting_on_bodies(model, stage, bodies);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const bool turns = acting[i].turns_further() && model.stages[stage].kinematics == Kinematics::finite;
    Blocks& fate = !acting[i].is_in_balance() ? all.falling : turns ? all.turning : all.resting;
    fate.insert(fate.end(), bodies[i].begin(), bodies[i].end());
  }
  return all;
}

void remark_on_stage(const Model& model, const std::string& stage, const NotHeld& all,
                     std::vector<std::string>& remarks) {
  const auto say = [&](const Blocks& found, const std::string& what) {
    if (found.empty()) return;
    remarks.push_back(fmt::format("stage \"{}\" is static, and {} touches nothing that is held: {}", stage,
                                  blocks_named(model, found), what));
  };
  say(all.falling, "it has no equilibrium");
  say(all.turning, fmt::format("what acts on it is in balance, but presses in directions that stay, so that it turns "
                               "ever further once it has turned a little; {}",
                               how_to_hold));
  say(all.resting, fmt::format("what acts on it is in balance, but nothing keeps it where it is; {}", how_to_hold));
}

}  // namespace

std::vector<std::string> holding_remarks(const Model& model, const ContactSet& contacts) {
  std::vector<std::string> remarks;
  const std::vector<Interface> interfaces = drawn_interfaces(model, contacts);
  const std::set<int> held = held_blocks_of(model);
  const auto blocks = static_cast<int>(model.blocks.size());
  if (held.empty() && model.viscous_edges.empty() && !model.gravity.isZero(0))
    remarks.emplace_back("nothing holds the blocks, and there is gravity: they all fall without end");
  for (std::size_t stage = 0; stage < model.stages.size(); ++stage)
    if (model.stages[stage].integrator.is_static)
      remark_on_stage(model, model.stages[stage].name,
                      by_fate(model, stage, Bodies(model, interfaces, stage).not_held(held, blocks)), remarks);
  return remarks;
}

}  // namespace dda
