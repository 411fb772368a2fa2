// Runs in which blocks come and go, the first frame not having all of them. The oracle: the outlines and motions of the
// model that was written, by the names of its blocks, and the lists of those that are there, drawn by lot.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/view/page.h"
#include "engine/view/run_results.h"
#include "engine/view/svg_picture.h"
#include "engine/view/view_test_support.h"

namespace dda {
namespace {

constexpr int seeds = 60;
constexpr double round_off = 1e-13 * 10;  // a few 2^-53 of coordinates up to 100 m

using Absent = std::vector<bool>;

// Squares, U-shaped blocks and frames with a hole, side by side.
Model row_of_blocks(std::mt19937& random) {
  const Model kinds = model_to_view();
  Model model = kinds;
  model.bolts.clear();
  model.blocks.clear();
  const auto count = 2 + random() % 8;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& kind = kinds.blocks[random() % kinds.blocks.size()];
    Block& block = model.blocks.emplace_back(kind);
    block.name = "block " + std::to_string(i);
    const Vec2 shift(10 * static_cast<double>(i) - kind.shape.outer[0].x(), 0);
    for (Vec2& vertex : block.shape.outer) vertex += shift;
    for (Ring& hole : block.shape.holes)
      for (Vec2& vertex : hole) vertex += shift;
  }
  finish_model(model);
  return model;
}

// A contact between each two blocks that are there, one after the other.
std::vector<ContactPoint> contacts_of(const Model& model, const State& state, const Absent& absent) {
  std::vector<ContactPoint> contacts;
  int before = -1;
  for (int block = 0; block < static_cast<int>(absent.size()); ++block) {
    if (absent[static_cast<std::size_t>(block)]) continue;
    if (before >= 0) {
      ContactPoint& contact = contacts.emplace_back();
      contact.block_a = before;
      contact.block_b = block;
      contact.reference = model.blocks[static_cast<std::size_t>(block)].shape.outer[0];
      contact.point = current_position(model, state, block, contact.reference);
      contact.normal = {1, 0};
      contact.normal_force = -1000.0 * (block + 1);
    }
    before = block;
  }
  return contacts;
}

struct Written {
  Model model;
  std::vector<Absent> absent;  // of each frame
};

Written write_run_of_lot(const std::filesystem::path& folder, int seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  Written run{row_of_blocks(random), {}};
  const unsigned share = 1 + random() % 4;  // one in so many is away
  run.absent.resize(2 + random() % 5, Absent(run.model.blocks.size()));
  for (Absent& absent : run.absent)
    for (std::size_t block = 0; block < absent.size(); ++block) absent[block] = random() % (share + 1) == 0;
  run.absent.back()[random() % run.model.blocks.size()] = false;
  FrameWriter frames(run.model, folder / "frames.pvd");
  ContactFrameWriter contacts(folder / "contacts.pvd");
  for (std::size_t frame = 0; frame < run.absent.size(); ++frame) {
    const State state = state_at(run.model, 0.5 * static_cast<double>(frame));
    contacts.write(state.time, contacts_of(run.model, state, run.absent[frame]));
    frames.write(state, run.absent[frame]);
  }
  return run;
}

bool is_ever_there(const Written& run, std::size_t block) {
  return !std::ranges::all_of(run.absent, [&](const Absent& absent) { return absent[block]; });
}

std::map<std::string, std::size_t> places_by_name(const Drawing& drawing) {
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < drawing.blocks(); ++i) places[drawing.names[i]] = i;
  return places;
}

void expect_outline(const Drawing& drawing, std::size_t place, const Polygon& shape) {
  std::vector<Ring> rings = {shape.outer};
  rings.insert(rings.end(), shape.holes.begin(), shape.holes.end());
  ASSERT_EQ(drawing.block_begin[place + 1] - drawing.block_begin[place], rings.size());
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const std::uint32_t ring = drawing.block_begin[place] + static_cast<std::uint32_t>(i);
    ASSERT_EQ(drawing.ring_begin[ring + 1] - drawing.ring_begin[ring], rings[i].size());
    for (const Vec2& vertex : rings[i])
      EXPECT_TRUE(std::any_of(drawing.reference.begin() + drawing.ring_begin[ring],
                              drawing.reference.begin() + drawing.ring_begin[ring + 1],
                              [&](const Vec2& drawn) { return (drawn - vertex).norm() <= round_off; }));
  }
}

void expect_frame(const Written& run, const RunResults& results, std::size_t number) {
  const Frame frame = results.frame(number);
  const State state = state_at(run.model, 0.5 * static_cast<double>(number));
  const auto places = places_by_name(results.drawing());
  for (std::size_t block = 0; block < run.model.blocks.size(); ++block) {
    if (!is_ever_there(run, block)) continue;
    const std::size_t place = places.at(run.model.blocks[block].name);
    ASSERT_EQ(is_present(frame, place), !run.absent[number][block]);
    const std::uint32_t vertex = results.drawing().ring_begin[results.drawing().block_begin[place]];
    EXPECT_EQ(frame.displacement[vertex].allFinite(), is_present(frame, place));
    if (!is_present(frame, place)) continue;
    EXPECT_EQ(frame.stress[place], state.stress[block]);
    EXPECT_LE((frame.displacement[vertex] - state.displacement[block].head<2>()).norm(), round_off);
  }
  const auto written = contacts_of(run.model, state, run.absent[number]);
  ASSERT_EQ(frame.contacts.size(), written.size());
  for (std::size_t i = 0; i < written.size(); ++i) {
    const auto name_of = [&](int block) { return run.model.blocks[static_cast<std::size_t>(block)].name; };
    EXPECT_EQ(frame.contacts[i].block_a, static_cast<int>(places.at(name_of(written[i].block_a))));
    EXPECT_EQ(frame.contacts[i].block_b, static_cast<int>(places.at(name_of(written[i].block_b))));
  }
}

class BlocksThatComeAndGo : public testing::TestWithParam<int> {};

TEST_P(BlocksThatComeAndGo, AreReadAsWritten) {
  const TemporaryFolder folder;
  const Written run = write_run_of_lot(folder.path(), GetParam());
  const RunResults results(folder.path());
  std::size_t seen = 0;
  for (std::size_t block = 0; block < run.model.blocks.size(); ++block) {
    if (!is_ever_there(run, block)) continue;
    ++seen;
    expect_outline(results.drawing(), places_by_name(results.drawing()).at(run.model.blocks[block].name),
                   run.model.blocks[block].shape);
  }
  ASSERT_EQ(results.drawing().blocks(), seen);
  for (std::size_t frame = 0; frame < run.absent.size(); ++frame) expect_frame(run, results, frame);
}

TEST_P(BlocksThatComeAndGo, AreDrawn) {
  const TemporaryFolder folder;
  const Written run = write_run_of_lot(folder.path(), GetParam());
  const RunResults results(folder.path());
  for (std::size_t frame = 0; frame < run.absent.size(); ++frame) {
    if (std::ranges::all_of(run.absent[frame], std::identity())) continue;
    EXPECT_NE(svg_picture(results.drawing(), results.frame(frame), {}).find("</svg>"), std::string::npos);
  }
  std::ostringstream out;
  write_page({folder.path(), folder / "view.html", "mean_stress", 50'000'000}, out);
  EXPECT_NE(out.str().find(std::to_string(results.drawing().blocks()) + " blocks"), std::string::npos) << out.str();
}

INSTANTIATE_TEST_SUITE_P(OfLots, BlocksThatComeAndGo, testing::Range(0, seeds));

}  // namespace
}  // namespace dda
