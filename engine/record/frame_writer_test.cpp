#include "engine/record/frame_writer.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>
#include <cstdlib>
#include <map>

#include "engine/core/read_file.h"
#include "engine/geometry/rotation.h"
#include "engine/record/record_test_support.h"
#include "engine/record/vtp_test_reader.h"

namespace dda {
namespace {

Block block_of(Polygon shape, int material) {
  Block block;
  block.shape = std::move(shape);
  block.moments = area_moments(block.shape);
  block.material = material;
  return block;
}

Ring square(double x, double y, double side) { return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}; }

// A square, an L and a square frame, of 1, 3 and 8 m2. The frame's cells: 2 lines, its rings, and 8 triangles.
Model three_blocks() {
  Model model;
  model.blocks.push_back(block_of({square(0, 0, 1), {}}, 1));
  model.blocks.push_back(block_of({{{2, 0}, {4, 0}, {4, 1}, {3, 1}, {3, 2}, {2, 2}}, {}}, 0));
  model.blocks.push_back(block_of({square(5, 0, 3), {{{6, 1}, {6, 2}, {7, 2}, {7, 1}}}}, 2));
  return model;
}

State moved_state(const Model& model) {
  State state = initial_state(model);
  state.time = 0.1 + 0.2;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const double k = static_cast<double>(i + 1);
    state.displacement[i] << 10 * k, -3 * k, 0.25 * k, 0.1, -0.05, 0.02;
    state.deformation[i] = deformation_increment(state.displacement[i]);
    state.velocity[i] << k, 2 * k, 3, 0.5, 0.25, 0.125;
    state.stress[i] << 3e6 * k, -1e6, 1.5e6;
  }
  return state;
}

class FrameWriterTest : public testing::Test {
 protected:
  VtpReader frame(const State& state) {
    FrameWriter(model_, index_).write(state);
    return VtpReader(folder_ / "run/000000.vtp");
  }

  TemporaryFolder folder_;
  std::filesystem::path index_ = folder_ / "run.pvd";
  Model model_ = three_blocks();
};

// The frame's two rings and eight triangles go, and come back in a later frame of the same writer.
TEST_F(FrameWriterTest, AbsentBlocksHavePointsAndNoCells) {
  FrameWriter writer(model_, index_);
  const State state = moved_state(model_);
  writer.write(state, {false, false, true});
  writer.write(state);
  const VtpReader without(folder_ / "run/000000.vtp");
  EXPECT_EQ(without.count("NumberOfPoints"), 4U + 6U + 8U);
  EXPECT_EQ(without.count("NumberOfLines"), 0U);
  EXPECT_EQ(without.count("NumberOfPolys"), 2U);
  const VtpReader with(folder_ / "run/000001.vtp");
  EXPECT_EQ(with.count("NumberOfLines"), 2U);
  EXPECT_EQ(with.count("NumberOfPolys"), 1U + 1U + 8U);
}

TEST_F(FrameWriterTest, FileIsCompleteAndSaysHowToReadIt) {
  const VtpReader vtp = frame(initial_state(model_));
  EXPECT_EQ(vtp.file().attributes.at("type"), "PolyData");
  EXPECT_EQ(vtp.file().attributes.at("version"), "1.0");
  EXPECT_EQ(vtp.file().attributes.at("byte_order"), "LittleEndian");
  EXPECT_EQ(vtp.file().attributes.at("header_type"), "UInt64");
  EXPECT_EQ(vtp.tail(), "\n</AppendedData>\n</VTKFile>\n");
  EXPECT_EQ(vtp.count("NumberOfPoints"), 4U + 6U + 8U);
  EXPECT_EQ(vtp.count("NumberOfVerts"), 0U);
  EXPECT_EQ(vtp.count("NumberOfLines"), 2U);
  EXPECT_EQ(vtp.count("NumberOfPolys"), 1U + 1U + 8U);
}

TEST_F(FrameWriterTest, ArraysHaveATupleForEveryCellOrPoint) {
  const VtpReader vtp = frame(initial_state(model_));
  for (const char* name : {"block", "material", "stress_xx [Pa]", "stress_yy [Pa]", "stress_xy [Pa]", "stress_1 [Pa]",
                           "stress_2 [Pa]", "rotation [rad]"}) {
    EXPECT_EQ(vtp.components(std::string("CellData/") + name), 1U) << name;
    EXPECT_EQ(vtp.cell(name).size(), 12U) << name;
  }
  for (const char* name : {"velocity [m/s]", "displacement [m]"}) {
    EXPECT_EQ(vtp.components(std::string("CellData/") + name), 3U) << name;
    EXPECT_EQ(vtp.cell(name).size(), 3U * 12U) << name;
    EXPECT_EQ(vtp.components(std::string("PointData/") + name), 3U) << name;
    EXPECT_EQ(vtp.point(name).size(), 3U * 18U) << name;
  }
  EXPECT_EQ(vtp.array("Points/Points").size(), 3U * 18U);
}

TEST_F(FrameWriterTest, EveryCellHasTheNameOfItsBlock) {
  const std::vector<std::string> names = {"wall 1.1", "L <&> \u00fc", ""};
  for (std::size_t i = 0; i < 3; ++i) model_.blocks[i].name = names[i];
  const VtpReader vtp = frame(initial_state(model_));
  const std::vector<std::string>& written = vtp.texts("CellData/block_name");
  ASSERT_EQ(written.size(), 12U);
  for (std::size_t cell = 0; cell < 12; ++cell)
    EXPECT_EQ(written[cell], names[static_cast<std::size_t>(vtp.cell("block")[cell])]) << cell;
}

TEST_F(FrameWriterTest, BlocksAsDrawnCoverTheirAreaAndNoHole) {
  const VtpReader vtp = frame(initial_state(model_));
  const std::map<int, double> expected = {{0, 1}, {1, 3}, {2, 8}};  // small integers: exact
  EXPECT_EQ(vtp.block_areas(), expected);
  for (std::size_t i = 0; i < vtp.count("NumberOfPolys"); ++i) {
    const auto corners = vtp.corners("Polys", i);
    const Polygon& shape = model_.blocks[vtp.block_of_polygon(i)].shape;
    // VTK draws a polygon as a fan from its first point.
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      EXPECT_GT(signed_area({corners[0], corners[k], corners[k + 1]}), 0) << i;
      EXPECT_TRUE(contains(shape, (corners[0] + corners[k] + corners[k + 1]) / 3)) << i;
    }
  }
  for (std::size_t cell = 0; cell < vtp.cell("block").size(); ++cell)
    EXPECT_EQ(vtp.cell("material")[cell], model_.blocks[static_cast<std::size_t>(vtp.cell("block")[cell])].material);
}

TEST_F(FrameWriterTest, RingsOfABlockThatIsTrianglesAreClosedLines) {
  const VtpReader vtp = frame(initial_state(model_));
  const Polygon& shape = model_.blocks[2].shape;
  const std::vector<Ring> rings = {shape.outer, shape.holes[0]};
  for (std::size_t i = 0; i < 2; ++i) {
    Ring closed = rings[i];
    closed.push_back(closed.front());
    EXPECT_EQ(vtp.corners("Lines", i), closed);
    EXPECT_EQ(vtp.cell("block")[i], 2);
  }
}

TEST(FanApex, IsAVertexThatSeesTheWholePolygon) {
  EXPECT_EQ(fan_apex({square(0, 0, 1), {}}), 0U);
  // In an L only the inner corner and the outer one on its diagonal see all of it.
  EXPECT_EQ(fan_apex({{{4, 0}, {4, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 0}}, {}}), 2U);
  const Ring letter_u = {{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  EXPECT_EQ(fan_apex({letter_u, {}}), std::nullopt);
  EXPECT_EQ(fan_apex({square(5, 0, 3), {{{6, 1}, {6, 2}, {7, 2}, {7, 1}}}}), std::nullopt);
}

TEST_F(FrameWriterTest, BlocksAreWhereTheyAreNow) {
  const State state = moved_state(model_);
  const VtpReader vtp = frame(state);
  std::size_t point = 0;
  for (std::size_t i = 0; i < model_.blocks.size(); ++i) {
    std::vector<Vec2> vertices = model_.blocks[i].shape.outer;
    for (const Ring& hole : model_.blocks[i].shape.holes) vertices.insert(vertices.end(), hole.begin(), hole.end());
    const Vec2 centroid = model_.blocks[i].moments.centroid;
    for (const Vec2& vertex : vertices) {
      const Vec2 offset = state.deformation[i] * (vertex - centroid);
      const Vec2 position = centroid + state.displacement[i].head<2>() + offset;
      const Vec2 velocity = displacement_rows(offset) * state.velocity[i];
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto row = static_cast<Eigen::Index>(axis);
        const double round_off = 1e-14 * 50;  // a few 2^-53 of coordinates up to 40
        EXPECT_NEAR(vtp.array("Points/Points")[3 * point + axis], position[row], round_off);
        EXPECT_NEAR(vtp.point("displacement [m]")[3 * point + axis], (position - vertex)[row], round_off);
        EXPECT_NEAR(vtp.point("velocity [m/s]")[3 * point + axis], velocity[row], round_off);
      }
      EXPECT_EQ(vtp.array("Points/Points")[3 * point + 2], 0);
      ++point;
    }
  }
  for (const auto& [block, area] : vtp.block_areas()) {
    const auto i = static_cast<std::size_t>(block);
    const double expected = model_.blocks[i].moments.area * state.deformation[i].determinant();
    EXPECT_NEAR(area, expected, 1e-12 * expected);  // 9 triangles at most, coordinates 40 m: 2^-53 * 40 m * 3 m each
  }
}

TEST_F(FrameWriterTest, CellsCarryTheStateOfTheirBlock) {
  const State state = moved_state(model_);
  const VtpReader vtp = frame(state);
  for (std::size_t cell = 0; cell < vtp.cell("block").size(); ++cell) {
    const auto i = static_cast<std::size_t>(vtp.cell("block")[cell]);
    EXPECT_EQ(vtp.cell("stress_xx [Pa]")[cell], state.stress[i][0]);
    EXPECT_EQ(vtp.cell("stress_yy [Pa]")[cell], state.stress[i][1]);
    EXPECT_EQ(vtp.cell("stress_xy [Pa]")[cell], state.stress[i][2]);
    EXPECT_EQ(vtp.cell("rotation [rad]")[cell], state.displacement[i][2]);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto row = static_cast<Eigen::Index>(axis);
      EXPECT_EQ(vtp.cell("velocity [m/s]")[3 * cell + axis], state.velocity[i][row]);
      EXPECT_EQ(vtp.cell("displacement [m]")[3 * cell + axis], state.displacement[i][row]);
    }
  }
  EXPECT_EQ(vtp.array("FieldData/TimeValue"), std::vector<double>{0.1 + 0.2});
}

TEST_F(FrameWriterTest, PrincipalStresses) {
  State state = initial_state(model_);
  state.stress[0] << 3, -1, 1.5;  // mean 1, radius sqrt(2^2 + 1.5^2) = 2.5
  state.stress[1] << 0, 0, -7;    // pure shear
  state.stress[2] << -5, -5, 0;
  const VtpReader vtp = frame(state);
  const std::vector<std::pair<double, double>> expected = {{3.5, -1.5}, {7, -7}, {-5, -5}};
  for (std::size_t cell = 0; cell < vtp.cell("block").size(); ++cell) {
    const auto [first, second] = expected[static_cast<std::size_t>(vtp.cell("block")[cell])];
    EXPECT_DOUBLE_EQ(vtp.cell("stress_1 [Pa]")[cell], first);
    EXPECT_DOUBLE_EQ(vtp.cell("stress_2 [Pa]")[cell], second);
  }
}

std::vector<std::pair<double, std::string>> entries_of(const std::filesystem::path& index) {
  std::vector<std::pair<double, std::string>> entries;
  for (const Element& element : XmlReader(read_file(index)).elements) {
    if (element.name != "DataSet") continue;
    EXPECT_EQ(element.parents, "VTKFile/Collection/");
    entries.emplace_back(std::strtod(element.attributes.at("timestep").c_str(), nullptr),
                         element.attributes.at("file"));
  }
  return entries;
}

TEST_F(FrameWriterTest, IndexListsEveryFrameWithItsTime) {
  FrameWriter writer(model_, index_);
  State state = initial_state(model_);
  std::vector<std::pair<double, std::string>> expected;
  for (const double time : {0.0, 0.1 + 0.2, 1e-5, 12345.678901234567}) {
    state.time = time;
    writer.write(state);
    expected.emplace_back(time, "run/00000" + std::to_string(expected.size()) + ".vtp");
    EXPECT_EQ(entries_of(index_), expected);
    EXPECT_EQ(VtpReader(folder_ / expected.back().second).array("FieldData/TimeValue"), std::vector<double>{time});
  }
  EXPECT_EQ(writer.frames(), 4);
  EXPECT_EQ(names_in(folder_.path()), (std::set<std::string>{"run", "run.pvd"}));
}

// An index of three frames is the same whether they were written by one run or by two.
TEST_F(FrameWriterTest, GoesOnBehindTheFramesOfAnEarlierRun) {
  State state = initial_state(model_);
  const auto write_at = [&](FrameWriter& writer, double time) {
    state.time = time;
    writer.write(state);
  };
  FrameWriter whole(model_, index_);
  for (const double time : {0.0, 0.1 + 0.2, 1e-5}) write_at(whole, time);
  const std::string index = read_file(index_);
  const std::string second_frame = read_file(folder_ / "run/000001.vtp");

  std::filesystem::remove(index_);
  FrameWriter resumed(model_, index_);
  const std::vector<double> earlier = {0.0, 0.1 + 0.2};
  resumed.go_on_after(earlier);
  write_at(resumed, 1e-5);
  EXPECT_EQ(resumed.frames(), 3);
  EXPECT_EQ(read_file(index_), index);
  EXPECT_EQ(read_file(folder_ / "run/000001.vtp"), second_frame);
}

TEST_F(FrameWriterTest, NamesWithSpecialCharacters) {
  index_ = folder_ / R"(a<b>&"c.pvd)";
  FrameWriter(model_, index_).write(initial_state(model_));
  ASSERT_EQ(entries_of(index_).size(), 1U);
  const VtpReader vtp(folder_ / entries_of(index_)[0].second);
  EXPECT_EQ(vtp.count("NumberOfPoints"), 18U);
}

TEST_F(FrameWriterTest, NoBlocks) {
  const Model empty;
  FrameWriter(empty, index_).write(initial_state(empty));
  const VtpReader vtp(folder_ / "run/000000.vtp");
  EXPECT_EQ(vtp.count("NumberOfPoints"), 0U);
  EXPECT_EQ(vtp.count("NumberOfPolys"), 0U);
}

TEST_F(FrameWriterTest, MissingFolderIsNamed) {
  EXPECT_EQ(message_of<std::runtime_error>([&] { FrameWriter(model_, folder_ / "missing/run.pvd"); }),
            "cannot create folder " + (folder_ / "missing/run").string() + ": No such file or directory");
}

TEST_F(FrameWriterTest, FullDiskKeepsTheEarlierFramesAndTheirIndex) {
  FrameWriter writer(model_, index_);
  writer.write(initial_state(model_));
  const std::string before = read_file(index_);
  {
    const FullDisk full(2000);
    EXPECT_THROW(writer.write(moved_state(model_)), std::runtime_error);
  }
  EXPECT_EQ(read_file(index_), before);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "run/000001.vtp"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "run/000001.vtp.tmp"));
  writer.write(moved_state(model_));  // once there is room again
  EXPECT_EQ(entries_of(index_).size(), 2U);
}

TEST(XmlReaderOfTheTests, FindsWhatIsNotWellFormed) {
  EXPECT_NO_THROW(XmlReader("<a x=\"1\"><b/></a>"));
  EXPECT_THROW(XmlReader("<a><b></a></b>"), std::runtime_error);
  EXPECT_THROW(XmlReader("<a>"), std::runtime_error);
  EXPECT_THROW(XmlReader("<a x=1/>"), std::runtime_error);
  EXPECT_THROW(XmlReader("<a x=\"b&c\"/>"), std::runtime_error);
  EXPECT_THROW(XmlReader("<a x=\"1\" x=\"2\"/>"), std::runtime_error);
}

}  // namespace
}  // namespace dda
