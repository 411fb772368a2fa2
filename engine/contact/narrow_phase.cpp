#include "engine/contact/narrow_phase.h"

#include "engine/contact/real_overlap.h"

namespace dda {

// Appends those of the covers that are contacts.
void NarrowPhase::choose(const CoverRange& range, std::vector<VertexContact>& found) {
  if (covers_.empty()) return;
  drop_unreal(outlines_, range.round_off, covers_, pressed_);
  choose_at_corners(outlines_, range.reach, range.round_off, covers_, ends_);
  for (const Cover& cover : covers_) found.push_back(cover.contact);
}

void NarrowPhase::find(int a, int b, const CoverRange& range, std::vector<VertexContact>& found) {
  find_covers(outlines_, a, b, range, covers_);
  choose(range, found);
}

void NarrowPhase::find(int a, int b, const CoverRange& range, const std::function<bool(const VertexContact&)>& is_out,
                       std::vector<VertexContact>& found) {
  find_covers(outlines_, a, b, range, covers_);
  std::erase_if(covers_, [&](const Cover& cover) { return is_out(cover.contact); });
  choose(range, found);
}

}  // namespace dda
