#include "engine/contact/contact_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "engine/contact/narrow_phase.h"
#include "engine/core/parallel.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

constexpr double growth = 0.1;           // of a block's size, on every side of its bounds
constexpr double growth_by_width = 0.3;  // of a slender block's width, so that it does not reach beyond its neighbours
constexpr double deepest = 0.1;     // of the smaller size: a vertex further inside has not come in through this edge
constexpr double round_off = 1e-9;  // of the smaller size: gaps and places on edges nearer than this are the same

// What was looked for further away than usual is so for the next steps too, as blocks do not stop from one step to the
// next; each step takes this share of it.
constexpr double remembered = 0.9;

// A pair's reach, or a block's room, is made this many times the motion seen, so that the next steps fit as well.
constexpr double margin = 1.5;

// Pairs are looked at in so many pieces, where there are enough of them to share.
constexpr std::size_t pieces_of_pairs = 16;
constexpr std::size_t pairs_worth_sharing = 512;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

ContactSearch::ContactSearch(const Model& model, const State& state) : outlines_(make_outlines(model, state)) {
  for (const Block& block : model.blocks) sizes_.push_back(std::sqrt(block.moments.area));
  smallest_size_ = *std::min_element(sizes_.begin(), sizes_.end());
  room_.assign(sizes_.size(), 0);
  for (std::size_t i = 0; i < sizes_.size(); ++i) {
    const Box along = slanted_box(outlines_, static_cast<int>(i)).box;
    const double width = (along.upper - along.lower).minCoeff();
    // Twice what contacts are looked for in at least, or lists would hardly ever hold.
    growth_.push_back(std::clamp(growth_by_width * width, 2 * reach * sizes_[i], growth * sizes_[i]));
  }
  list_pairs();
}

void ContactSearch::list_pairs() {
  must_list_ = false;
  std::vector<double> margins(sizes_.size());
  for (std::size_t i = 0; i < margins.size(); ++i) margins[i] = is_absent(i) ? -1 : growth_[i] + lift_ + room_[i];
  bounds_.set(outlines_, margins);
  const std::vector<std::pair<int, int>> before = std::exchange(pairs_, bounds_.overlapping());
  const std::vector<double> wider_before = std::exchange(wider_, std::vector<double>(pairs_.size(), 0.0));
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (wider_before[k] == 0) continue;
    const auto place = std::lower_bound(pairs_.begin(), pairs_.end(), before[k]);
    if (place != pairs_.end() && *place == before[k])
      wider_[at(static_cast<int>(place - pairs_.begin()))] = wider_before[k];
  }
}

bool ContactSearch::update(const Model& model, const State& state, double lift) {
  lift_ = lift;
  if (!std::exchange(just_widened_, false)) forget_slowly();
  update_outlines(model, state, outlines_);
  bool left = must_list_;
  for (std::size_t i = 0; i < sizes_.size() && !left; ++i)
    left = !is_absent(i) && !bounds_.hold(outlines_, static_cast<int>(i), reach * sizes_[i] + lift_);
  if (left) list_pairs();
  return left;
}

void ContactSearch::leave_out(const std::vector<bool>& absent) {
  absent_ = absent;
  list_pairs();
}

double ContactSearch::reach_of(std::size_t pair) const {
  return std::max(reach * std::min(size_of(pairs_[pair].first), size_of(pairs_[pair].second)), wider_[pair]);
}

void ContactSearch::forget_slowly() {
  const auto fade = [](double& each, double usual) { each = each > usual ? remembered * each : 0; };
  for (std::size_t i = 0; i < room_.size(); ++i) fade(room_[i], reach * sizes_[i]);
  for (double& each : wider_) fade(each, 0.0);
}

double ContactSearch::largest_motion(const Eigen::VectorXd& d) const {
  double largest = 0;
  for (int i = 0; i < outlines_.blocks(); ++i) {
    if (is_absent(at(i))) continue;
    const Vec6 own = d.segment<6>(6 * i);
    const Box& box = outlines_.boxes[at(i)];
    largest = std::max(largest, own.head<2>().norm() + own.tail<4>().lpNorm<1>() * (box.upper - box.lower).norm());
  }
  return largest;
}

// As steps see it, or as blocks are moved: gaps of a step are of first order, and a contact that comes in by the second
// must be known for it, as one that is found in depth does not press.
bool ContactSearch::closes(const VertexContact& contact, std::span<const MovingBox> blocks) const {
  const MovingBox& of_edge = blocks[at(contact.edge_block)];
  const MovingBox& of_vertex = blocks[at(contact.vertex_block)];
  const Vec2& vertex = outlines_.current[at(contact.vertex)];
  const Vec2 opening = displacement_at(of_vertex, vertex) - displacement_at(of_edge, vertex);
  if (contact.gap + contact.normal.dot(opening) < 0) return true;
  const Vec2 start = place_after(of_edge, outlines_.current[at(contact.edge)]);
  const Vec2 end = place_after(of_edge, outlines_.current[at(outlines_.next[at(contact.edge)])]);
  return cross(end - start, place_after(of_vertex, vertex) - start) > 0;  // the block is on the left of its edges
}

// Contacts of the pair that are found from as far away as its blocks move against each other, m, and close. All others
// have no force in what was solved, so that a step that knew of them would come to the same.
bool ContactSearch::misses_contact(int a, int b, double relative, std::span<const MovingBox> blocks,
                                   const SeenContacts& seen) const {
  if (std::ranges::binary_search(seen.of_stretches, std::pair{a, b})) return false;
  const double smaller = std::min(size_of(a), size_of(b));
  std::vector<VertexContact> found;
  NarrowPhase(outlines_).find(a, b, {margin * relative + lift_, deepest * smaller, round_off * smaller}, found);
  return std::ranges::any_of(found, [&](const VertexContact& contact) {
    return !std::binary_search(seen.contacts.begin(), seen.contacts.end(), contact) && closes(contact, blocks) &&
           !held_.stand_for(outlines_, contact);
  });
}

// The same of a block that leaves its bounds and others with which it is no pair.
bool ContactSearch::meets_unlisted(int block, std::span<const MovingBox> blocks, std::span<const double> motion,
                                   const SeenContacts& seen) const {
  for (int other = 0; other < outlines_.blocks(); ++other) {
    const auto [a, b] = std::minmax(block, other);
    if (a == b || is_absent(at(other)) || std::ranges::binary_search(pairs_, std::pair{a, b})) continue;
    const double relative = relative_displacement(blocks[at(a)], blocks[at(b)], motion[at(a)] + motion[at(b)]);
    if (relative > 0 && misses_contact(a, b, relative, blocks, seen)) return true;
  }
  return false;
}

bool ContactSearch::widen(const Model& model, const State& state, const Eigen::VectorXd& d, const SeenContacts& seen) {
  std::vector<MovingBox> blocks(sizes_.size());
  std::vector<double> motion(sizes_.size());
  for (int i = 0; i < outlines_.blocks(); ++i) {
    if (is_absent(at(i))) continue;
    blocks[at(i)] = {outlines_.boxes[at(i)], local_centroid(model, state, i), d.segment<6>(6 * i)};
    motion[at(i)] = largest_displacement(blocks[at(i)]);
  }
  bool wider = false;
  for (int i = 0; i < outlines_.blocks(); ++i) {
    if (is_absent(at(i)) || bounds_.hold(outlines_, i, motion[at(i)])) continue;
    if (!meets_unlisted(i, blocks, motion, seen)) continue;
    room_[at(i)] = margin * motion[at(i)];
    must_list_ = wider = true;
  }
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const auto [a, b] = pairs_[k];
    const double both = motion[at(a)] + motion[at(b)];
    if (both <= reach_of(k)) continue;
    const double relative = relative_displacement(blocks[at(a)], blocks[at(b)], both);
    if (relative <= reach_of(k) || !misses_contact(a, b, relative, blocks, seen)) continue;
    wider_[k] = margin * relative;
    wider = true;
  }
  just_widened_ = wider;
  return wider;
}

template <typename... IsOut>
void ContactSearch::find_of_pair(std::size_t k, NarrowPhase& narrow, std::vector<VertexContact>& found,
                                 const IsOut&... is_out) const {
  const auto [a, b] = pairs_[k];
  const double smaller = std::min(size_of(a), size_of(b));
  const std::size_t before = found.size();
  narrow.find(a, b, {reach_of(k) + lift_, deepest * smaller, round_off * smaller}, is_out..., found);
  if (held_.empty()) return;
  const auto first = found.begin() + static_cast<std::ptrdiff_t>(before);
  const auto is_held = [&](const VertexContact& contact) { return held_.stand_for(outlines_, contact); };
  found.erase(std::remove_if(first, found.end(), is_held), found.end());
}

void ContactSearch::find_between(int a, int b, const std::function<bool(const VertexContact&)>& is_out,
                                 std::vector<VertexContact>& found) const {
  const auto pair = std::lower_bound(pairs_.begin(), pairs_.end(), std::pair{a, b});
  NarrowPhase narrow(outlines_);
  find_of_pair(static_cast<std::size_t>(pair - pairs_.begin()), narrow, found, is_out);
}

std::vector<VertexContact> ContactSearch::find(const std::vector<std::pair<int, int>>& bonded) const {
  std::array<std::vector<VertexContact>, pieces_of_pairs> found;
  for_each_piece({pairs_.size(), pairs_.size() < pairs_worth_sharing ? 1 : pieces_of_pairs},
                 [&](std::size_t piece, std::size_t first, std::size_t last) {
                   if (first == last) return;
                   NarrowPhase narrow(outlines_);
                   auto held = std::lower_bound(bonded.begin(), bonded.end(), pairs_[first]);
                   for (std::size_t k = first; k < last; ++k) {
                     while (held != bonded.end() && *held < pairs_[k]) ++held;
                     if (held == bonded.end() || *held != pairs_[k]) find_of_pair(k, narrow, found[piece]);
                   }
                 });
  std::vector<VertexContact> all = std::move(found[0]);
  for (std::size_t i = 1; i < found.size(); ++i) all.insert(all.end(), found[i].begin(), found[i].end());
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace dda
