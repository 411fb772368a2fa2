// A name means one set of blocks, whatever carries it, or is refused. Random scenes are read as text and through an
// oracle that knows only the lists of names.
#include "engine/scene/named_blocks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/scene/scene.h"

namespace dda {
namespace {

// Squares in a row, with few names for all that has one, so that they often coincide.
struct Row {
  std::vector<std::string> materials, groups, names;

  explicit Row(unsigned seed) {
    std::mt19937 random(seed);
    const std::vector<std::string> few{"wall", "rock", "floor", "a", "b"};
    std::set<std::string> taken;
    for (std::size_t i = 0, count = 1 + random() % 5; i < count; ++i) {
      materials.push_back(few[random() % 2]);
      groups.push_back(few[random() % few.size()]);
      const std::string name = few[random() % few.size()];
      names.push_back(taken.insert(name).second ? name : fmt::format("block {}", i));
    }
  }

  [[nodiscard]] std::string scene(const std::string& rest) const {
    std::string blocks;
    for (std::size_t i = 0; i < names.size(); ++i)
      blocks += fmt::format(
          R"({}{{"polygon": {{"name": "{}", "group": "{}", "material": "{}", "vertices": [[{},0],[{},0],[{},1],[{},1]]}}}})",
          i > 0 ? ",\n" : "", names[i], groups[i], materials[i], 2 * i, 2 * i + 1, 2 * i + 1, 2 * i);
    return fmt::format(R"({{"dda": 1, "materials": {{"wall": {}, "rock": {}}}, "joints": {{"default": {{}}}},
 "blocks": [{}], {}, "steps": {{"dt": 1e-3, "duration": 1}}}})",
                       rock, rock, blocks, rest);
  }

  static constexpr auto rock = R"({"density": 2600, "young": 1e9, "poisson": 0.2})";
};

std::set<std::size_t> with(const std::vector<std::string>& list, const std::string& name) {
  std::set<std::size_t> found;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i] == name) found.insert(i);
  return found;
}

// The sets of blocks that the name has in these lists, where any has it.
std::set<std::set<std::size_t>> meanings(const std::string& name,
                                         const std::vector<const std::vector<std::string>*>& lists) {
  std::set<std::set<std::size_t>> sets;
  for (const auto* list : lists)
    if (auto found = with(*list, name); !found.empty()) sets.insert(std::move(found));
  return sets;
}

template <typename Members>
void expect_one_meaning(const std::set<std::set<std::size_t>>& sets, const std::string& scene, const Members& members) {
  try {
    const std::vector<int> blocks = members(parse_scene(scene, "s"));
    ASSERT_EQ(sets.size(), 1U) << scene;
    EXPECT_EQ(std::set<std::size_t>(blocks.begin(), blocks.end()), *sets.begin()) << scene;
  } catch (const InputError& error) {
    EXPECT_NE(sets.size(), 1U) << error.what() << scene;
    const bool says = std::string(error.what()).find(", the name of a") != std::string::npos;
    EXPECT_EQ(says, sets.size() > 1) << error.what() << scene;
  }
}

TEST(NamedBlocks, OfRandomScenes) {
  std::size_t refused = 0, taken = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Row row(seed);
    for (const char* name : {"wall", "rock", "a"}) {
      const auto sets = meanings(name, {&row.materials, &row.groups, &row.names});
      ++(sets.size() > 1 ? refused : taken);
      expect_one_meaning(
          sets, row.scene(fmt::format(R"("measurements": [{{"quantity": "kinetic_energy", "group": "{}"}}])", name)),
          [](const Model& model) { return model.measurements[0].blocks; });
      expect_one_meaning(meanings(name, {&row.groups, &row.names}), row.scene(fmt::format(R"("fixed": ["{}"])", name)),
                         [](const Model& model) {
                           std::vector<int> held;
                           for (const HeldBlock& block : model.held_blocks) held.push_back(block.block);
                           return held;
                         });
    }
  }
  EXPECT_GT(refused, 100U);
  EXPECT_GT(taken, 100U);
}

TEST(NamedBlocks, RefusalNamesBothKinds) {
  const std::string scene = R"({"dda": 1, "materials": {"wall": {"density": 2600, "young": 1e9, "poisson": 0.2}},
 "joints": {"default": {}},
 "blocks": [{"bar": {"name": "wall", "length": 2, "height": 1, "block_length": 1}},
            {"polygon": {"name": "floor", "vertices": [[0, -1], [2, -1], [2, 0], [0, 0]]}}],
 "measurements": [{"quantity": "kinetic_energy", "group": "wall"}], "steps": {"dt": 1e-3, "duration": 1}})";
  try {
    parse_scene(scene, "s.json");
    ADD_FAILURE() << "taken";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "s.json: measurements[0].group is \"wall\", the name of a group (2 blocks) and of a material (3 blocks), "
        "expected a name that means one of them; give the other another name");
  }
}

}  // namespace
}  // namespace dda
