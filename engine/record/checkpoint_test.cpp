#include "engine/record/checkpoint.h"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/record/atomic_file.h"
#include "engine/record/fnv_hash.h"
#include "engine/record/record_test_support.h"

namespace dda {
namespace {

Model three_blocks() {
  Model model;
  model.materials.resize(2);
  model.joints.resize(1);
  for (int i = 0; i < 3; ++i) {
    Block block;
    block.shape.outer = {{1.0 * i, 0}, {i + 1.0, 0}, {i + 1.0, 1}, {1.0 * i, 1}};
    model.blocks.push_back(block);
  }
  model.joint_of_block_pair[{0, 1}] = 0;
  return model;
}

State random_state(std::size_t blocks) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  State state;
  state.time = 0.1 + 0.2;
  state.step = 123'456'789'012;
  for (std::size_t i = 0; i < blocks; ++i) {
    const auto draw = [&](auto like) -> decltype(like) {
      return like.unaryExpr([&](double) { return normal(random); });
    };
    state.displacement.push_back(draw(Vec6(Vec6::Zero())));
    state.velocity.push_back(draw(Vec6(Vec6::Zero())));
    state.acceleration.push_back(draw(Vec6(Vec6::Zero())));
    state.stress.push_back(draw(Vec3(Vec3::Zero())));
    state.deformation.push_back(draw(Mat2(Mat2::Zero())));
  }
  state.velocity[0][0] = -0.0;
  state.velocity[0][1] = std::numeric_limits<double>::quiet_NaN();
  state.velocity[0][2] = std::numeric_limits<double>::denorm_min();
  return state;
}

template <typename Array>
bool same_bits(const std::vector<Array>& a, const std::vector<Array>& b) {
  return a.size() == b.size() && std::memcmp(a.front().data(), b.front().data(), a.size() * sizeof(Array)) == 0;
}

void expect_same_bits(const State& a, const State& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.step, b.step);
  EXPECT_TRUE(same_bits(a.displacement, b.displacement));
  EXPECT_TRUE(same_bits(a.velocity, b.velocity));
  EXPECT_TRUE(same_bits(a.acceleration, b.acceleration));
  EXPECT_TRUE(same_bits(a.stress, b.stress));
  EXPECT_TRUE(same_bits(a.deformation, b.deformation));
}

std::vector<std::byte> some_bytes() {
  std::vector<std::byte> bytes(1001);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(i * 7);
  return bytes;
}

class CheckpointFile : public testing::Test {
 protected:
  CheckpointFile() { save_checkpoint(path_, model_, state_, {some_bytes()}); }

  std::string refusal() const {
    return message_of<InputError>([&] { load_checkpoint(path_, model_); });
  }
  // The refusal after `change` is made to the file's bytes.
  std::string refusal_of(const std::function<void(std::string&)>& change) const {
    std::string bytes = read_file(path_);
    change(bytes);
    write_file(path_, bytes);
    return refusal();
  }
  std::string is(const std::string& rest) const { return path_.string() + ": checkpoint is " + rest; }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "run.checkpoint";
  Model model_ = three_blocks();
  State state_ = random_state(3);
};

TEST_F(CheckpointFile, GivesBackEveryBit) {
  const Checkpoint read = load_checkpoint(path_, model_);
  expect_same_bits(read.state, state_);
  EXPECT_EQ(read.extra, some_bytes());
}

TEST_F(CheckpointFile, WithoutExtraBytes) {
  save_checkpoint(path_, model_, state_);
  const Checkpoint read = load_checkpoint(path_, model_);
  expect_same_bits(read.state, state_);
  EXPECT_TRUE(read.extra.empty());
}

TEST_F(CheckpointFile, OfAModelWithoutBlocks) {
  State empty;
  empty.time = 3;
  save_checkpoint(path_, Model{}, empty);
  EXPECT_EQ(load_checkpoint(path_, Model{}).state.time, 3);
}

TEST_F(CheckpointFile, MissingOrAFolder) {
  std::filesystem::remove(path_);
  EXPECT_EQ(refusal(), is("missing, expected a readable file"));
  std::filesystem::create_directory(path_);
  EXPECT_EQ(refusal(), is("a directory, expected a readable file"));
}

TEST_F(CheckpointFile, OfAnotherKind) {
  const std::string foreign = is("some other kind of file, expected one that starts with DDASTATE");
  EXPECT_EQ(refusal_of([](std::string& bytes) { bytes[0] = 'X'; }), foreign);
  EXPECT_EQ(refusal_of([](std::string& bytes) { bytes = R"({"blocks": []})"; }), foreign);
  EXPECT_EQ(refusal_of([](std::string& bytes) { bytes.clear(); }), foreign);
}

TEST_F(CheckpointFile, OfAnotherVersionOrByteOrder) {
  EXPECT_EQ(refusal_of([](std::string& bytes) { bytes[8] = 1; }), is("of version 1, expected version 2"));
  EXPECT_EQ(refusal_of([](std::string& bytes) { std::swap(bytes[12], bytes[15]); }),
            is("of a machine with another byte order, expected one of this machine's"));
}

// Whatever byte changes and wherever the file is cut, it is refused and never half read.
TEST_F(CheckpointFile, DamageAnywhereIsFound) {
  const std::string good = read_file(path_);
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x10);
    write_file(path_, bad);
    ASSERT_NE(refusal(), "") << "byte " << i;
    i += i < 100 ? 0 : 17;
  }
  write_file(path_, good);
  EXPECT_EQ(refusal_of([&](std::string& bytes) { bytes[bytes.size() - 9] = '!'; }),
            is("damaged (its checksum does not fit), expected an intact file"));
}

TEST_F(CheckpointFile, CutOffAnywhereOrTooLong) {
  const std::string good = read_file(path_);
  for (std::size_t size = 0; size < good.size(); size += size < 100 ? 1 : 53) {
    write_file(path_, std::string_view(good).substr(0, size));
    ASSERT_NE(refusal(), "") << size << " bytes";
  }
  const auto size = std::to_string(good.size());
  write_file(path_, std::string_view(good).substr(0, 100));
  EXPECT_EQ(refusal(), is("100 bytes long, expected " + size + " bytes, a whole file"));
  write_file(path_, std::string_view(good).substr(0, 20));
  EXPECT_EQ(refusal(), is("cut off after 20 bytes, expected a whole file"));
  write_file(path_, good + "x");
  EXPECT_EQ(refusal(), is(std::to_string(good.size() + 1) + " bytes long, expected " + size + " bytes, a whole file"));
}

// The sizes are checked against each other, so that even a wrong file with a fitting checksum reads nothing beyond it.
TEST_F(CheckpointFile, SizesThatDoNotFit) {
  EXPECT_EQ(refusal_of([](std::string& bytes) {
              bytes[40] = static_cast<char>(bytes[40] + 1);  // of the number of extra bytes
              bytes.resize(bytes.size() - sizeof(std::uint64_t));
              FnvHash hash;
              hash.add(bytes);
              const std::uint64_t checksum = hash.value();
              bytes.append(reinterpret_cast<const char*>(&checksum), sizeof checksum);
            }),
            is("damaged (its sizes do not fit), expected an intact file"));
}

TEST_F(CheckpointFile, OfAnotherScene) {
  model_.blocks[2].shape.outer[1].x() += 1e-12;
  EXPECT_EQ(refusal(), is("of another scene or other records (it has 3 blocks), expected one with the 3 blocks, the "
                          "materials, the joints and the records of this scene"));
  model_.blocks.pop_back();
  EXPECT_EQ(refusal(), is("of another scene or other records (it has 3 blocks), expected one with the 2 blocks, the "
                          "materials, the joints and the records of this scene"));
}

TEST_F(CheckpointFile, FullDiskKeepsTheEarlierOne) {
  State later = state_;
  later.time = 99;
  {
    const FullDisk full(200);
    EXPECT_THROW(save_checkpoint(path_, model_, later), std::runtime_error);
  }
  EXPECT_EQ(load_checkpoint(path_, model_).state.time, state_.time);
  EXPECT_EQ(names_in(folder_.path()), std::set<std::string>{"run.checkpoint"});
}

HeldBlock shaken_by(const std::vector<double>& values) {
  HeldBlock held;
  held.history = Recorded{std::make_shared<const Recording>("", std::vector{0.0, 1.0, 2.0}, values), 0};
  return held;
}

TEST(Fingerprint, ChangesWithWhatGivesTheStateItsMeaning) {
  const std::vector<std::function<void(Model&)>> changes = {
      [](Model& m) { m.blocks.pop_back(); },
      [](Model& m) { std::swap(m.blocks[0], m.blocks[1]); },
      [](Model& m) { m.blocks[0].material = 1; },
      [](Model& m) {
        m.blocks[0].shape.holes.push_back({{0.1, 0.1}, {0.1, 0.2}, {0.2, 0.1}});
      },
      [](Model& m) { m.materials[1].young = 1; },
      [](Model& m) { m.materials[1].poisson = 0.1; },
      [](Model& m) { m.materials[1].density = 1; },
      [](Model& m) { m.materials[1].plane = PlaneState::strain; },
      [](Model& m) { m.joints[0].law = InterfaceLaw::classical; },
      [](Model& m) { m.joints[0].bonded = true; },
      [](Model& m) { m.joints[0].friction_angle = 0.5; },
      [](Model& m) { m.joints[0].stabilisation = 0.5; },
      [](Model& m) { m.joint_of_block_pair.clear(); },
      [](Model& m) { m.held_blocks.resize(1); },
      [](Model& m) {
        m.held_blocks = {shaken_by({0, 1, 2})};
      },
      [](Model& m) {
        m.held_blocks = {shaken_by({0, 1, 3})};
      },
      [](Model& m) { m.bolts.resize(1); },
      [](Model& m) {
        m.bolts.resize(1);
        m.bolts[0].pretension = 1;
      },
      [](Model& m) {
        m.bolts.resize(1);
        m.bolts[0].links.resize(1);
      },
  };
  std::set<std::uint64_t> found = {fingerprint(three_blocks())};
  for (const auto& change : changes) {
    Model model = three_blocks();
    change(model);
    found.insert(fingerprint(model));
  }
  EXPECT_EQ(found.size(), changes.size() + 1);
}

TEST(Fingerprint, AllowsOtherNamesLoadsAndStages) {
  Model model = three_blocks();
  const std::uint64_t before = fingerprint(model);
  model.title = "other";
  model.blocks[0].name = "other";
  model.gravity = {0, -9.81};
  model.stages.resize(2);
  model.point_loads.resize(1);
  model.measurements.resize(1);
  EXPECT_EQ(fingerprint(model), before);
}

// Published test vectors of 64-bit FNV-1a.
TEST(FnvHash, KnownValues) {
  const auto hash = [](std::string_view text) {
    FnvHash sum;
    sum.add(text);
    return sum.value();
  };
  EXPECT_EQ(hash(""), 0xcbf29ce484222325U);
  EXPECT_EQ(hash("a"), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(hash("foobar"), 0x85944171f73967e8U);
}

}  // namespace
}  // namespace dda
