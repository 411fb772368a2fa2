#include "engine/contact/narrow_phase.h"

#include "engine/contact/cover_corners.h"
#include "engine/contact/entrance_cover.h"
#include "engine/contact/real_overlap.h"

namespace dda {
namespace {

// Appends those of the covers that are contacts.
void choose(const Outlines& outlines, double reach, double round_off, std::vector<Cover>& covers,
            std::vector<VertexContact>& found) {
  if (covers.empty()) return;
  drop_unreal(outlines, round_off, covers);
  choose_at_corners(outlines, reach, round_off, covers);
  for (const Cover& cover : covers) found.push_back(cover.contact);
}

}  // namespace

void find_vertex_contacts(const Outlines& outlines, int a, int b, double reach, double depth, double round_off,
                          std::vector<VertexContact>& found) {
  std::vector<Cover> covers = find_covers(outlines, a, b, reach, depth, round_off);
  choose(outlines, reach, round_off, covers, found);
}

void find_vertex_contacts(const Outlines& outlines, int a, int b, double reach, double depth, double round_off,
                          const std::function<bool(const VertexContact&)>& is_out, std::vector<VertexContact>& found) {
  std::vector<Cover> covers = find_covers(outlines, a, b, reach, depth, round_off);
  std::erase_if(covers, [&](const Cover& cover) { return is_out(cover.contact); });
  choose(outlines, reach, round_off, covers, found);
}

}  // namespace dda
