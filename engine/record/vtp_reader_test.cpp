#include "engine/record/vtp_reader.h"

#include <gtest/gtest.h>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/record/atomic_file.h"
#include "engine/record/record_test_support.h"
#include "engine/record/vtp_series.h"

namespace dda {
namespace {

using std::string_literals::operator""s;

// A line and a triangle over three points, and a vertex.
PolyData sample() {
  PolyData data;
  data.time = 0.1 + 0.2;
  data.points = {0, 0, 0, 1, 0, 0, 1e-9, 1.0 / 3, 0};
  data.vertices = {{2}, {1}};
  data.lines = {{0, 1}, {2}};
  data.polygons = {{0, 1, 2}, {3}};
  data.point_data = {{"force <&\"> [N]", 3, std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9}}};
  data.cell_data = {{"block", 1, std::vector<std::int32_t>{5, 6, 7}},
                    {"name", 1, std::vector<std::string>{"a b", "", "\u00fc<"}}};
  return data;
}

class VtpFileTest : public testing::Test {
 protected:
  std::string refusal(const std::string& text) const {
    write_file(folder_ / "a.vtp", text);
    return message_of<InputError>([&] { read_vtp(folder_ / "a.vtp"); });
  }

  std::string with(const std::string& from, const std::string& to) const {
    std::string text = text_;
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("not there: " + from);
    return text.replace(at, from.size(), to);
  }

  VtpFileTest() {
    write_vtp(folder_ / "a.vtp", sample());
    text_ = read_file(folder_ / "a.vtp");
  }

  TemporaryFolder folder_;
  std::string text_;
};

TEST_F(VtpFileTest, ReadsBackWhatWasWritten) {
  const PolyData written = sample();
  const PolyData read = read_vtp(folder_ / "a.vtp");
  EXPECT_EQ(read.time, written.time);
  EXPECT_EQ(read.points, written.points);
  for (const auto cells : {&PolyData::vertices, &PolyData::lines, &PolyData::polygons}) {
    EXPECT_EQ((read.*cells).connectivity, (written.*cells).connectivity);
    EXPECT_EQ((read.*cells).offsets, (written.*cells).offsets);
  }
  EXPECT_EQ(*find_array<double>(read.point_data, "force <&\"> [N]", 3),
            std::get<std::vector<double>>(written.point_data[0].values));
  EXPECT_EQ(*find_array<std::int32_t>(read.cell_data, "block", 1), (std::vector<std::int32_t>{5, 6, 7}));
  EXPECT_EQ(*find_array<std::string>(read.cell_data, "name", 1), (std::vector<std::string>{"a b", "", "\u00fc<"}));
  EXPECT_EQ(find_array<double>(read.cell_data, "block", 1), nullptr);
  EXPECT_EQ(find_array<std::int32_t>(read.cell_data, "block", 3), nullptr);
  EXPECT_EQ(find_array<std::int32_t>(read.cell_data, "stress", 1), nullptr);
}

TEST_F(VtpFileTest, EveryFileThatIsCutOffIsRefused) {
  const std::size_t all_data = text_.rfind("\n</AppendedData>");
  for (std::size_t length = 0; length < all_data; length += 13)
    EXPECT_NE(refusal(text_.substr(0, length)).find("a.vtp: the file is "), std::string::npos) << length;
  EXPECT_EQ(refusal(text_.substr(0, all_data)), "");  // nothing that is needed is missing
}

TEST_F(VtpFileTest, SaysWhatIsWrongAndWhatToDo) {
  EXPECT_EQ(message_of<InputError>([&] { read_vtp(folder_ / "b.vtp"); }),
            (folder_ / "b.vtp").string() +
                ": the file is missing, expected what dda run --frames writes; run the scene again");
  EXPECT_NE(refusal("some text").find("no .vtp file"), std::string::npos);
  EXPECT_NE(refusal(with("LittleEndian", "BigEndian")).find("another byte order"), std::string::npos);
  EXPECT_NE(refusal(with("Int32", "Int31")).find("type \"Int31\""), std::string::npos);
  EXPECT_NE(refusal(with("offset=\"0\"", "offset=\"x\"")).find("damaged"), std::string::npos);
  EXPECT_NE(refusal(with("a b\0"s, "a bc")).find("(name)"), std::string::npos) << "a text too few";
  EXPECT_NE(refusal(with("<\0"s, "<c")).find("(name)"), std::string::npos) << "a text without end";
  EXPECT_NE(refusal(with("NumberOfComponents=\"3\"", "NumberOfComponents=\"2\"")).find("force"), std::string::npos);
}

TEST_F(VtpFileTest, CellsOfPointsThatAreNotThereAreRefused) {
  for (const std::int64_t point : {-1, 3}) {
    PolyData data = sample();
    data.polygons.connectivity[1] = point;
    write_vtp(folder_ / "c.vtp", data);
    EXPECT_THROW(read_vtp(folder_ / "c.vtp"), InputError);
  }
  for (const std::int64_t end : {-1, 2, 4}) {
    PolyData data = sample();
    data.polygons.offsets[0] = end;
    write_vtp(folder_ / "c.vtp", data);
    EXPECT_THROW(read_vtp(folder_ / "c.vtp"), InputError);
  }
}

TEST_F(VtpFileTest, SeriesIsReadBack) {
  VtpSeries series(folder_ / "a&b.pvd");
  PolyData data = sample();
  for (const double time : {0.0, 0.1 + 0.2}) {
    data.time = time;
    series.add(data);
  }
  const auto entries = read_series(folder_ / "a&b.pvd");
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[1].time, 0.1 + 0.2);
  EXPECT_EQ(entries[1].file, folder_ / "a&b/000001.vtp");
  EXPECT_EQ(read_vtp(entries[1].file).time, 0.1 + 0.2);

  const std::string text = read_file(folder_ / "a&b.pvd");
  write_file(folder_ / "cut.pvd", text.substr(0, text.size() / 2));
  EXPECT_THROW(read_series(folder_ / "cut.pvd"), InputError);
  write_file(folder_ / "bad.pvd", R"(<VTKFile><DataSet timestep="1x" file="a"/></VTKFile>)");
  EXPECT_THROW(read_series(folder_ / "bad.pvd"), InputError);
  EXPECT_THROW(read_series(folder_ / "missing.pvd"), InputError);
}

}  // namespace
}  // namespace dda
