#include "engine/view/run_results.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/view/view_test_support.h"

namespace dda {
namespace {

constexpr double round_off = 1e-14 * 10;  // a few 2^-53 of coordinates up to 10 m

class RunResultsTest : public testing::Test {
 protected:
  RunResultsTest() { write_run(folder_.path(), model_, {0, 0.5, 1}); }

  [[nodiscard]] std::string refusal() const {
    return message_of<InputError>([&] {
      const RunResults results(folder_.path());
      for (std::size_t i = 0; i < results.times().size(); ++i) (void)results.frame(i);
    });
  }

  TemporaryFolder folder_;
  Model model_ = model_to_view();
};

TEST_F(RunResultsTest, OutlinesAreThoseOfTheModel) {
  const RunResults results(folder_.path());
  const Drawing& drawing = results.drawing();
  EXPECT_EQ(results.times(), (std::vector<double>{0, 0.5, 1}));
  ASSERT_EQ(drawing.blocks(), 3U);
  EXPECT_EQ(drawing.names, (std::vector<std::string>{"square", "U", "frame"}));
  EXPECT_EQ(drawing.block_begin, (std::vector<std::uint32_t>{0, 1, 2, 4}));
  ASSERT_EQ(drawing.rings(), 4U);
  const Polygon& frame = model_.blocks[2].shape;
  const std::vector<Ring> rings = {model_.blocks[0].shape.outer, model_.blocks[1].shape.outer, frame.outer,
                                   frame.holes[0]};
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    ASSERT_EQ(drawing.ring_begin[ring + 1] - drawing.ring_begin[ring], rings[ring].size());
    for (std::size_t i = 0; i < rings[ring].size(); ++i)
      EXPECT_LE((drawing.reference[drawing.ring_begin[ring] + i] - rings[ring][i]).norm(), round_off);
  }
}

TEST_F(RunResultsTest, FramesAreTheStates) {
  const RunResults results(folder_.path());
  const Frame frame = results.frame(1);
  const State state = state_at(model_, 0.5);
  EXPECT_EQ(frame.time, 0.5);
  for (std::size_t block = 0; block < 3; ++block) {
    EXPECT_EQ(frame.stress[block], state.stress[block]);
    EXPECT_EQ(frame.velocity[block], state.velocity[block].head<2>());
    EXPECT_EQ(frame.moved[block], state.displacement[block].head<2>());
    for (std::uint32_t ring = results.drawing().block_begin[block]; ring < results.drawing().block_begin[block + 1];
         ++ring)
      for (std::uint32_t i = results.drawing().ring_begin[ring]; i < results.drawing().ring_begin[ring + 1]; ++i)
        EXPECT_LE((frame.displacement[i] - state.displacement[block].head<2>()).norm(), round_off);
  }
}

TEST_F(RunResultsTest, RemovedBlocksAreNowhere) {
  FrameWriter writer(model_, folder_.path() / "frames.pvd");
  writer.write(state_at(model_, 0));
  writer.write(state_at(model_, 1), {false, true, false});
  const RunResults results(folder_.path());
  ASSERT_EQ(results.times().size(), 2U);
  for (std::size_t block = 0; block < 3; ++block) EXPECT_TRUE(is_present(results.frame(0), block));
  const Frame frame = results.frame(1);
  const State state = state_at(model_, 1);
  const Drawing& drawing = results.drawing();
  for (std::size_t block = 0; block < 3; ++block) {
    EXPECT_EQ(is_present(frame, block), block != 1);
    const Vec2& first = frame.displacement[drawing.ring_begin[drawing.block_begin[block]]];
    EXPECT_EQ(first.allFinite(), block != 1);
    if (block == 1) continue;
    EXPECT_EQ(frame.stress[block], state.stress[block]);
    EXPECT_LE((first - state.displacement[block].head<2>()).norm(), round_off);
  }
}

TEST_F(RunResultsTest, ContactsAreThoseWritten) {
  const RunResults results(folder_.path());
  EXPECT_TRUE(results.has_contacts());
  const auto contacts = results.frame(2).contacts;
  const auto written = contacts_at(model_, state_at(model_, 1));
  ASSERT_EQ(contacts.size(), written.size());
  for (std::size_t i = 0; i < written.size(); ++i) {
    EXPECT_EQ(contacts[i].block_a, written[i].block_a);
    EXPECT_EQ(contacts[i].block_b, written[i].block_b);
    EXPECT_EQ(contacts[i].force, written[i].force());
    EXPECT_FALSE(contacts[i].tension);
    EXPECT_LE((contacts[i].reference - written[i].reference).norm(), round_off);
    EXPECT_LE((contacts[i].displacement - (written[i].point - written[i].reference)).norm(), round_off);
  }
  EXPECT_EQ(contacts[0].status, DrawnStatus::locked);
  EXPECT_EQ(contacts[1].status, DrawnStatus::sliding);
  EXPECT_EQ(contacts[2].status, DrawnStatus::open);
}

TEST_F(RunResultsTest, AContactsStatusIsOpenSlidingOrLocked) {
  auto contacts = contacts_at(model_, state_at(model_, 0.5));
  contacts[0].status = static_cast<ContactStatus>(3);  // a bolt may wait, a contact may not
  ContactFrameWriter(folder_ / "other.pvd").write(0.5, contacts);
  std::filesystem::rename(folder_ / "other/000000.vtp", folder_ / "contacts/000001.vtp");
  EXPECT_NE(refusal().find("with the unknown status 3"), std::string::npos) << refusal();
}

TEST_F(RunResultsTest, ContactsMayBeMissing) {
  std::filesystem::remove(folder_ / "contacts.pvd");
  const RunResults results(folder_.path());
  EXPECT_FALSE(results.has_contacts());
  EXPECT_TRUE(results.frame(2).contacts.empty());
}

TEST_F(RunResultsTest, SaysWhatToDoWhereThereAreNoFrames) {
  const std::string folder = (folder_ / "none").string();
  EXPECT_EQ(message_of<InputError>([&] { RunResults{folder}; }),
            "the folder " + folder + " is missing, expected results with frames: dda run SCENE.json --out " + folder +
                " --frames 100");
  std::filesystem::create_directory(folder);
  EXPECT_NE(message_of<InputError>([&] { RunResults{folder}; }).find("is without frames.pvd, expected"),
            std::string::npos);
}

TEST_F(RunResultsTest, BrokenFilesAreNamed) {
  const std::string whole = read_file(folder_ / "frames/000001.vtp");
  write_file(folder_ / "frames/000001.vtp", whole.substr(0, whole.size() / 2));
  EXPECT_NE(refusal().find("000001.vtp: the file is cut off"), std::string::npos) << refusal();
  std::filesystem::remove(folder_ / "frames/000001.vtp");
  EXPECT_NE(refusal().find("000001.vtp: the file is missing"), std::string::npos) << refusal();
  write_file(folder_ / "frames/000001.vtp", whole);
  EXPECT_EQ(refusal(), "");
  std::filesystem::remove(folder_ / "contacts/000002.vtp");
  EXPECT_NE(refusal().find("contacts/000002.vtp: the file is missing"), std::string::npos) << refusal();
}

TEST_F(RunResultsTest, FramesOfOtherBlocksAreRefused) {
  const TemporaryFolder other;
  Model smaller = model_to_view();
  smaller.bolts.clear();
  smaller.blocks.pop_back();
  finish_model(smaller);
  FrameWriter(smaller, other / "frames.pvd").write(state_at(smaller, 0.5));
  std::filesystem::copy_file(other / "frames/000000.vtp", folder_ / "frames/000001.vtp",
                             std::filesystem::copy_options::overwrite_existing);
  EXPECT_NE(refusal().find("of other blocks than the first frame"), std::string::npos) << refusal();
}

TEST_F(RunResultsTest, BoltsAreMaterialLinesWithTheirForce) {
  EXPECT_FALSE(RunResults(folder_.path()).has_bolts());
  EXPECT_TRUE(RunResults(folder_.path()).frame(0).bolts.empty());
  write_bolts(folder_.path(), model_, {0, 0.5, 1});
  const RunResults results(folder_.path());
  ASSERT_TRUE(results.has_bolts());
  const std::vector<DrawnBolt> bolts = results.frame(1).bolts;
  ASSERT_EQ(bolts.size(), 2U);
  EXPECT_EQ(bolts[0].name, "tie");
  EXPECT_EQ(bolts[0].force, 1000);
  EXPECT_EQ(bolts[0].condition, DrawnCondition::elastic);
  EXPECT_EQ(bolts[1].name, "<grouted>");
  EXPECT_EQ(bolts[1].force, -1000);
  EXPECT_EQ(bolts[1].condition, DrawnCondition::yielded);
  EXPECT_EQ(results.frame(2).bolts[1].condition, DrawnCondition::broken);
  const std::vector<Vec2> reference = {{4.25, 0.5}, {5, 0.5}, {6, 0.5}, {6.5, 0.5}};
  ASSERT_EQ(bolts[1].reference.size(), reference.size());
  for (std::size_t i = 0; i < reference.size(); ++i) {
    EXPECT_LE((bolts[1].reference[i] - reference[i]).norm(), round_off);
    // It moves with its block, the second or the third, by (i + 1) 0.5 s (0.1, -0.2) m/s.
    EXPECT_LE((bolts[1].displacement[i] - (i < 2 ? 1.0 : 1.5) * Vec2(0.1, -0.2)).norm(), round_off);
  }
}

TEST_F(RunResultsTest, BoltsMayWaitForTheirStage) {
  write_bolts(folder_.path(), model_, {0, 0.5, 1});
  const auto put_first_bolt = [&](BoltCondition condition) {
    BoltFrameWriter other(model_, folder_ / "other.pvd");
    other.write(state_at(model_, 0),
                std::vector<BoltLinkValues>{{Vec2(0, 0), 0, condition}, {Vec2(0, 0), 0, BoltCondition::elastic}});
    std::filesystem::rename(folder_ / "other/000000.vtp", folder_ / "bolts/000000.vtp");
  };
  put_first_bolt(BoltCondition::waiting);
  EXPECT_EQ(RunResults(folder_.path()).frame(0).bolts[0].condition, DrawnCondition::waiting);
  put_first_bolt(static_cast<BoltCondition>(4));
  EXPECT_NE(refusal().find("with the unknown status 4"), std::string::npos) << refusal();
}

// Elements of linings are drawn behind bolts: tension is positive, and those still to be sprayed are not shown.
TEST_F(RunResultsTest, LiningsAreLinesLikeBolts) {
  Lining lining;
  lining.name = "shotcrete";
  lining.nodes = {{0, {0.5, 0}, {1, 0}}, {1, {3, 0}, {1, 0}}, {2, {7, 0}, {1, 0}}};
  model_.linings = {lining};
  EXPECT_FALSE(RunResults(folder_.path()).has_linings());
  LiningFrameWriter linings(model_, folder_ / "linings.pvd");
  for (const double time : {0.0, 0.5, 1.0})
    linings.write(state_at(model_, time), std::vector<LiningValues>{{2000, 0, 0, 0, LiningCondition::yielded},
                                                                    {0, 0, 0, 0, LiningCondition::waiting}});
  write_bolts(folder_.path(), model_, {0, 0.5, 1});
  const RunResults results(folder_.path());
  ASSERT_TRUE(results.has_linings());
  const std::vector<DrawnBolt> lines = results.frame(1).bolts;
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[2].name, "shotcrete");
  EXPECT_EQ(lines[2].force, -2000);
  EXPECT_EQ(lines[2].condition, DrawnCondition::yielded);
  EXPECT_EQ(lines[3].condition, DrawnCondition::waiting);
  for (const DrawnBolt& line : lines) EXPECT_TRUE(std::isnan(line.utilisation)) << "nothing carries any strength";
  EXPECT_LE((lines[2].reference[1] - Vec2(3, 0)).norm(), round_off);
  EXPECT_LE((lines[2].displacement[1] - Vec2(0.1, -0.2)).norm(), round_off);
}

// Bolts have no utilisation, and neither have linings of which no element carries a share of its strength.
TEST_F(RunResultsTest, LiningsHaveTheirUtilisation) {
  model_.linings.resize(2);
  for (Lining& lining : model_.linings)
    lining.nodes = {{0, {0.5, 0}, {1, 0}}, {1, {3, 0}, {1, 0}}, {2, {7, 0}, {1, 0}}};
  model_.linings[0].name = "elastic";
  model_.linings[1].name = "strong";
  LiningFrameWriter linings(model_, folder_ / "linings.pvd");
  for (const double time : {0.0, 0.5, 1.0})
    linings.write(state_at(model_, time),
                  std::vector<LiningValues>{{2000, 0, 0, 0, LiningCondition::elastic},
                                            {2000, 0, 0, 0, LiningCondition::elastic},
                                            {0, 0, 0, 0, LiningCondition::elastic},
                                            {2000, 0, 0, 0.7 * time, LiningCondition::elastic}});
  write_bolts(folder_.path(), model_, {0, 0.5, 1});
  const RunResults results(folder_.path());
  const std::vector<DrawnBolt> lines = results.frame(2).bolts;
  ASSERT_EQ(lines.size(), 6U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(std::isnan(lines[i].utilisation)) << i;
  EXPECT_EQ(lines[4].utilisation, 0);
  EXPECT_EQ(lines[5].utilisation, 0.7);
  EXPECT_TRUE(std::isnan(results.frame(0).bolts[5].utilisation));
}

TEST_F(RunResultsTest, RefusesBoltsOfOtherFrames) {
  write_bolts(folder_.path(), model_, {0, 0.5});
  EXPECT_NE(refusal().find("bolts.pvd: the file is shorter than frames.pvd"), std::string::npos) << refusal();
  write_bolts(folder_.path(), model_, {0, 0.5, 1});
  EXPECT_EQ(refusal(), "");
  model_.bolts.pop_back();
  BoltFrameWriter other(model_, folder_ / "other.pvd");
  other.write(state_at(model_, 1), std::vector<BoltLinkValues>(1));
  std::filesystem::rename(folder_ / "other/000000.vtp", folder_ / "bolts/000002.vtp");
  EXPECT_NE(refusal().find("of other bolts than the first frame"), std::string::npos) << refusal();
}

}  // namespace
}  // namespace dda
