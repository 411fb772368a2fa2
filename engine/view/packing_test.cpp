#include "engine/view/packing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>

#include "engine/view/view_test_support.h"

namespace dda {
namespace {

template <typename Integer>
std::vector<Integer> integers(const std::string& bytes) {
  std::vector<Integer> values(bytes.size() / sizeof(Integer));
  std::memcpy(values.data(), bytes.data(), bytes.size());  // tests run on little-endian machines
  return values;
}

double decoded(std::uint16_t code, const nlohmann::ordered_json& range) {
  const double low = range[0].get<double>();
  return low + (range[1].get<double>() - low) * code / 65534;
}

TEST(Codes, AreWithinHalfAStepOfTheirValues) {
  const std::vector<double> values = {-3e6, 0, 1, 2.5e6, 1e-3};
  std::string bytes = "xy";  // codes are appended
  const CodeRange range = append_codes(values, bytes);
  EXPECT_EQ(range.low, -3e6);
  EXPECT_EQ(range.high, 2.5e6);
  const auto codes = integers<std::uint16_t>(bytes.substr(2));
  ASSERT_EQ(codes.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_NEAR(decoded(codes[i], {range.low, range.high}), values[i], 5.5e6 / 65534 / 2 * (1 + 1e-9));
}

TEST(Codes, OfWhatIsNoNumberSaySo) {
  std::string bytes;
  const CodeRange range = append_codes(std::vector<double>{std::nan(""), 4, -INFINITY}, bytes);
  EXPECT_EQ(range.low, 4);
  EXPECT_EQ(range.high, 4);
  EXPECT_EQ(integers<std::uint16_t>(bytes), (std::vector<std::uint16_t>{65535, 0, 65535}));
  EXPECT_EQ(append_codes(std::vector<double>{std::nan("")}, bytes).low, 0);
}

class PackedRunTest : public testing::Test {
 protected:
  PackedRunTest() {
    for (std::size_t i = 0; i < 3; ++i) run_.add(results_.frame(i));
    header_ = run_.header();
    for (auto& [name, bytes] : run_.sections()) sections_[name] = bytes;
  }

  [[nodiscard]] const std::filesystem::path& written() const {
    write_run(folder_.path(), model_, {0, 0.5, 1});
    return folder_.path();
  }

  TemporaryFolder folder_;
  Model model_ = model_to_view();
  RunResults results_{written()};
  PackedRun run_{results_.drawing()};
  nlohmann::ordered_json header_;
  std::map<std::string, std::string> sections_;
};

TEST_F(PackedRunTest, HoldsEveryQuantityOfEveryFrame) {
  EXPECT_EQ(header_["times"], (std::vector<double>{0, 0.5, 1}));
  for (std::size_t q = 0; q < drawn_quantity_count; ++q) {
    const auto& quantity = header_["quantities"][q];
    const auto codes = integers<std::uint16_t>(sections_.at("quantity-" + quantity["id"].get<std::string>()));
    ASSERT_EQ(codes.size(), 9U);
    for (std::size_t f = 0; f < 3; ++f) {
      const Frame frame = results_.frame(f);
      const auto& range = quantity["ranges"][f];
      const double half_step = (range[1].get<double>() - range[0].get<double>()) / 65534 / 2;
      for (std::size_t block = 0; block < 3; ++block)
        EXPECT_NEAR(decoded(codes[3 * f + block], range), drawn_quantities[q].value(frame, block),
                    half_step * (1 + 1e-6));
    }
  }
}

TEST_F(PackedRunTest, HoldsEveryVertexOfEveryFrame) {
  const std::size_t vertices = results_.drawing().reference.size();
  const auto reference = integers<float>(sections_.at("reference"));
  ASSERT_EQ(reference.size(), 2 * vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    const Vec2 expected = results_.drawing().reference[i] - results_.drawing().reference[0];
    EXPECT_EQ(reference[2 * i], static_cast<float>(expected.x()));
    EXPECT_EQ(reference[2 * i + 1], static_cast<float>(expected.y()));
  }
  const auto codes = integers<std::uint16_t>(sections_.at("displacement-y"));
  ASSERT_EQ(codes.size(), 3 * vertices);
  for (std::size_t f = 0; f < 3; ++f)
    for (std::size_t i = 0; i < vertices; ++i)
      EXPECT_NEAR(decoded(codes[f * vertices + i], header_["displacement_y"][f]), results_.frame(f).displacement[i].y(),
                  0.6 / 65534);  // the largest displacement
}

TEST_F(PackedRunTest, HoldsContactsInTheOrderOfTheirStatus) {
  const std::vector<std::uint32_t> locked_sliding_open = {1, 0, 1, 1};
  for (std::size_t f = 0; f < 3; ++f) EXPECT_EQ(header_["contact_counts"][f], locked_sliding_open);
  const auto forces = integers<std::int16_t>(sections_.at("contact-forces"));
  ASSERT_EQ(forces.size(), 3U * 2U * 2U);
  const double unit = header_["force_units"][2].get<double>();
  EXPECT_NEAR(forces[8] * unit, 4000, unit);
  EXPECT_NEAR(forces[9] * unit, 0, unit);
  EXPECT_NEAR(forces[10] * unit, 1000, unit);
  const auto numbers = integers<std::uint16_t>(sections_.at("contact-sites"));
  ASSERT_EQ(numbers.size(), 9U);
  const auto sites = integers<std::uint32_t>(sections_.at("sites"));
  ASSERT_EQ(sites.size(), 3U * 5U);           // the same in every frame
  EXPECT_EQ(sites[5U * numbers[6] + 1], 1U);  // the locked one is on block 1
  EXPECT_EQ(sites[5U * numbers[7] + 1], 2U);
}

// The 99 % quantile of so few forces (4, 2, 0, 1, 0.5 and 0 kN/m) is the second largest of them.
TEST_F(PackedRunTest, SaysWhichForceIsDrawnThickest) {
  EXPECT_NEAR(header_["thickest_force"]["contacts"].get<double>(), 2000, 1e-9);
  EXPECT_NEAR(header_["thickest_force"]["joints"].get<double>(), 2000, 1e-9);

  PackedRun pairs(results_.drawing());
  Frame frame = results_.frame(2);
  frame.contacts = {frame.contacts[0], frame.contacts[0]};
  frame.contacts[1].force *= 2;
  std::swap(frame.contacts[1].block_a, frame.contacts[1].block_b);  // the other block: it pushes the other way
  frame.contacts[1].force *= -1;
  pairs.add(frame);
  EXPECT_NEAR(pairs.header()["thickest_force"]["contacts"].get<double>(), 4000, 1e-9);
  EXPECT_NEAR(pairs.header()["thickest_force"]["joints"].get<double>(), 12000, 1e-9);
}

TEST_F(PackedRunTest, SaysItsSize) {
  std::size_t bytes = 0;
  for (const auto& [name, section] : sections_) bytes += section.size();
  EXPECT_EQ(run_.size(), bytes * 4 / 3);
}

// 2,500 bricks with 15,000 contacts, 200 frames: what docs/running.md promises.
TEST(PackedRunSize, OfALargeWallIsBelowFiftyMegabytes) {
  Drawing drawing;
  drawing.ring_begin = drawing.block_begin = {0};
  Frame frame;
  for (std::uint32_t block = 0; block < 2500; ++block) {
    for (const Vec2& corner : square_ring(block % 50, block / 50, 1)) drawing.reference.push_back(corner);
    drawing.ring_begin.push_back(4 * block + 4);
    drawing.block_begin.push_back(block + 1);
    for (int i = 0; i < 6; ++i) {
      DrawnContact contact;
      contact.block_b = static_cast<int>(block);
      contact.block_a = static_cast<int>(block + 1 + static_cast<unsigned>(i)) % 2500;
      contact.reference = drawing.reference[4 * block + static_cast<unsigned>(i) % 4];
      contact.force = Vec2(1, 2);
      contact.status = DrawnStatus::locked;
      frame.contacts.push_back(contact);
    }
  }
  frame.displacement.assign(10000, Vec2(0, -1e-4));
  frame.stress.assign(2500, Vec3(-1, -2, 0));
  frame.velocity = frame.moved = std::vector<Vec2>(2500, Vec2(0, 0));
  PackedRun run(drawing);
  run.add(frame);
  const std::size_t first = run.size();
  run.add(frame);
  const std::size_t each = run.size() - first;
  EXPECT_LT(first + 199 * each, 50'000'000U);
}

TEST_F(PackedRunTest, HoldsNothingOfBoltsWhereThereAreNone) {
  EXPECT_TRUE(header_["bolts"].is_null());
  for (const auto& [name, bytes] : sections_) EXPECT_FALSE(name.starts_with("bolt")) << name;
}

TEST_F(PackedRunTest, HoldsBolts) {
  const std::size_t without = run_.size();
  write_bolts(folder_.path(), model_, {0, 0.5, 1});
  const RunResults results(folder_.path());
  PackedRun run(results.drawing());
  for (std::size_t i = 0; i < 3; ++i) run.add(results.frame(i));
  const auto bolts = run.header()["bolts"];
  std::map<std::string, std::string> sections;
  for (auto& [name, bytes] : run.sections()) sections[name] = bytes;
  EXPECT_EQ(bolts["names"], (std::vector<std::string>{"tie", "<grouted>"}));
  EXPECT_EQ(bolts["begin"], (std::vector<int>{0, 2, 6}));
  EXPECT_EQ(bolts["most_force"], 2000);
  EXPECT_EQ(integers<std::uint8_t>(sections.at("bolt-condition")), (std::vector<std::uint8_t>{0, 1, 0, 1, 0, 2}));
  const auto reference = integers<float>(sections.at("bolt-reference"));
  EXPECT_EQ(reference, (std::vector<float>{0.5F, 0.5F, 2.5F, 0.5F, 4.25F, 0.5F, 5, 0.5F, 6, 0.5F, 6.5F, 0.5F}));
  const auto x = integers<std::uint16_t>(sections.at("bolt-x"));
  const auto y = integers<std::uint16_t>(sections.at("bolt-y"));
  const auto force = integers<std::uint16_t>(sections.at("bolt-force"));
  ASSERT_EQ(x.size(), 18U);
  ASSERT_EQ(y.size(), 18U);
  for (std::size_t f = 0; f < 3; ++f) {
    const std::vector<DrawnBolt> own = results.frame(f).bolts;
    // Numbers are packed to half a step of the largest range: 0.6 m, and 3 kN.
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(decoded(x[6 * f + 2 + i], bolts["x"][f]), own[1].displacement[i].x(), 0.6 / 65534);
      EXPECT_NEAR(decoded(y[6 * f + 2 + i], bolts["y"][f]), own[1].displacement[i].y(), 0.6 / 65534);
    }
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(decoded(force[2 * f + i], bolts["force"][f]), own[i].force, 3000.0 / 65534);
  }
  EXPECT_TRUE(bolts["utilisation"].is_null());
  EXPECT_FALSE(sections.contains("bolt-utilisation"));
  EXPECT_GE(run.size(), without + (12 * 4 + 3 * (2 * 12 + 2 * 2 + 2)) * 4 / 3);
}

TEST_F(PackedRunTest, HoldsTheUtilisationOfLinings) {
  write_bolts(folder_.path(), model_, {0, 0.5, 1});
  const RunResults results(folder_.path());
  PackedRun run(results.drawing());
  Frame frame = results.frame(0);
  frame.bolts[1].utilisation = 0.25;
  run.add(frame);
  std::map<std::string, std::string> sections;
  for (auto& [name, bytes] : run.sections()) sections[name] = bytes;
  const auto codes = integers<std::uint16_t>(sections.at("bolt-utilisation"));
  ASSERT_EQ(codes.size(), 2U);
  EXPECT_EQ(codes[0], 65535) << "a bolt has none";
  EXPECT_EQ(decoded(codes[1], run.header()["bolts"]["utilisation"][0]), 0.25);
}

}  // namespace
}  // namespace dda
