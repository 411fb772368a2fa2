// The first search for contacts in scenes as they are published.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/contact/contact_search.h"
#include "engine/scene/scene.h"

namespace dda {
namespace {

std::vector<std::filesystem::path> scenes_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json") scenes.push_back(entry.path());
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

// Scenes are written with ten and more digits, and finish_model() refuses blocks that overlap by more than this share
// of the smaller one, so that no gap is deeper as drawn.
constexpr double as_drawn = 1e-9;

void expect_no_depth(const Model& model) {
  const ContactSearch search(model, initial_state(model));
  for (const VertexContact& contact : search.find({})) {
    const double smaller = std::min(search.size_of(contact.edge_block), search.size_of(contact.vertex_block));
    EXPECT_GE(contact.gap, -as_drawn * smaller)
        << model.blocks[static_cast<std::size_t>(contact.edge_block)].name << " edge " << contact.edge << ", "
        << model.blocks[static_cast<std::size_t>(contact.vertex_block)].name << " vertex " << contact.vertex << " at "
        << search.outlines().current[static_cast<std::size_t>(contact.vertex)].transpose();
  }
}

// DDA_SCENES=FOLDER looks at the scenes of that folder as well.
TEST(FirstContacts, BlocksThatTouchAsDrawnAreNotInEachOther) {
  std::vector<std::filesystem::path> scenes = scenes_in(DDA_EXAMPLES);
  ASSERT_FALSE(scenes.empty());
  if (const char* folder = std::getenv("DDA_SCENES")) {
    const auto more = scenes_in(folder);
    scenes.insert(scenes.end(), more.begin(), more.end());
  }
  for (const auto& scene : scenes) {
    SCOPED_TRACE(scene.filename());
    expect_no_depth(read_scene(scene));
  }
}

}  // namespace
}  // namespace dda
