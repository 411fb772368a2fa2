#include "engine/contact/ending_stretches.h"

#include <algorithm>
#include <utility>

#include "engine/contact/contact_sharing.h"
#include "engine/contact/joint_of.h"
#include "engine/contact/projected_stretch.h"
#include "engine/core/parallel.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class PairsOfBlocks {
 public:
  void add(const std::pair<int, int>& pair) { pairs_.push_back(pair); }
  void sort() { std::sort(pairs_.begin(), pairs_.end()); }
  // The pairs must have been sorted.
  [[nodiscard]] bool has(const std::pair<int, int>& pair) const {
    return std::binary_search(pairs_.begin(), pairs_.end(), pair);
  }

 private:
  std::vector<std::pair<int, int>> pairs_;
};

}  // namespace

EndingStretches::EndingStretches(const Model& model) {
  for (const Block& block : model.blocks) is_convex_.push_back(points_outwards(block.shape) ? 1 : 0);
}

std::vector<char> EndingStretches::find(const Model& model, const State& state, const ContactSet& contacts,
                                        std::size_t stretches, bool dry_ones) const {
  std::vector<Hold> holds(stretches);
  parallel_for_each(stretches, contacts_worth_sharing,
                    [&](std::size_t i) { holds[i] = hold_of(model, state, contacts, i, dry_ones); });
  const bool all_stay = std::ranges::all_of(holds, [](const Hold& each) { return each.firm || each.closed; });
  return all_stay ? std::vector<char>(stretches, 0) : decide(model, contacts, holds);
}

bool EndingStretches::touch_there_alone(const Model& model, const Interface& interface) const {
  const bool both_convex = is_convex_[at(interface.block_a)] != 0 && is_convex_[at(interface.block_b)] != 0;
  return both_convex || dda::touch_there_alone(model, interface);
}

EndingStretches::Hold EndingStretches::hold_of(const Model& model, const State& state, const ContactSet& contacts,
                                               std::size_t stretch, bool dry_ones) const {
  const Interface& interface = contacts.interfaces[stretch];
  const auto& broken = contacts.states[stretch].broken;
  const bool holds = dry_ones ? !is_dry(joint_of(model, interface)) : !broken[0] || !broken[1];
  Hold own;
  own.firm = interface.length > 0 && holds;
  if (own.firm || contacts.elements.own()[stretch].law != InterfaceLaw::projected) return own;
  own.parted = has_parted(model, state, interface);
  own.closed = !own.parted;
  return own;
}

// A closed stretch of blocks that can touch elsewhere stays by itself; the others of a pair stay or end together.
std::vector<char> EndingStretches::decide(const Model& model, const ContactSet& contacts,
                                          const std::vector<Hold>& holds) const {
  PairsOfBlocks firm, closed, parted;
  std::vector<char> stays_by_itself(holds.size(), 0);
  for (std::size_t i = 0; i < holds.size(); ++i) {
    const std::pair<int, int> pair = blocks_of(contacts.interfaces[i]);
    if (holds[i].firm) firm.add(pair);
    if (holds[i].closed) {
      if (touch_there_alone(model, contacts.interfaces[i]))
        closed.add(pair);
      else
        stays_by_itself[i] = 1;
    }
    if (holds[i].parted) parted.add(pair);
  }
  for (PairsOfBlocks* each : {&firm, &closed, &parted}) each->sort();
  std::vector<char> ends(holds.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const std::pair<int, int> pair = blocks_of(contacts.interfaces[i]);
    const bool stays = stays_by_itself[i] != 0 || firm.has(pair) || (closed.has(pair) && !parted.has(pair));
    ends[i] = stays ? 0 : 1;
  }
  return ends;
}

std::vector<HeldFace> EndingStretches::held_faces(const Model& model, const ContactSet& contacts,
                                                  std::size_t stretches) const {
  std::vector<HeldFace> faces;
  PairsOfBlocks firm;
  for (std::size_t i = 0; i < stretches; ++i) {
    const Interface& interface = contacts.interfaces[i];
    const auto& broken = contacts.states[i].broken;
    if (!broken[0] || !broken[1])
      firm.add(blocks_of(interface));
    else if (contacts.elements.own()[i].law == InterfaceLaw::projected && !touch_there_alone(model, interface))
      faces.push_back(held_face(model, interface));
  }
  if (faces.empty()) return faces;
  firm.sort();
  std::erase_if(faces, [&](const HeldFace& face) { return firm.has(face.pair()); });
  return faces;
}

}  // namespace dda
