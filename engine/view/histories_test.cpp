#include "engine/view/histories.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "engine/record/history_writer.h"
#include "engine/view/view_test_support.h"

namespace dda {
namespace {

TEST(Histories, AreReadAsTheyWereWritten) {
  const TemporaryFolder folder;
  {
    HistoryWriter writer(folder / "h.csv", {{"a, \"quoted\" [name]", "Pa"}, {"ratio", ""}});
    writer.append(0, std::vector<double>{1.5, -2e-300});
    writer.append(0.1 + 0.2, std::vector<double>{std::nan(""), 1.0 / 3});
    writer.close();
  }
  const Histories histories = read_histories(folder / "h.csv");
  EXPECT_EQ(histories.times, (std::vector<double>{0, 0.1 + 0.2}));
  ASSERT_EQ(histories.columns.size(), 2U);
  EXPECT_EQ(histories.columns[0].name, "a, \"quoted\" [name]");
  EXPECT_EQ(histories.columns[0].unit, "Pa");
  EXPECT_EQ(histories.columns[1].unit, "-");
  EXPECT_EQ(histories.columns[0].values[0], 1.5);
  EXPECT_TRUE(std::isnan(histories.columns[0].values[1]));
  EXPECT_EQ(histories.columns[1].values, (std::vector<double>{-2e-300, 1.0 / 3}));
}

TEST(Histories, OfNoMeasurementsAreTimes) {
  const TemporaryFolder folder;
  write_file(folder / "h.csv", "time [s]\n0\n0.5\n");
  EXPECT_EQ(read_histories(folder / "h.csv").times, (std::vector<double>{0, 0.5}));
}

TEST(Histories, DamagedOnesAreRefused) {
  const TemporaryFolder folder;
  for (const char* text : {"", "a,b\n", "time [s],a [m]\n1\n", "time [s],a [m]\n1,2,3\n", "time [s],a [m]\n1,x\n"}) {
    write_file(folder / "h.csv", text);
    const std::string message = message_of<InputError>([&] { read_histories(folder / "h.csv"); });
    EXPECT_NE(message.find("h.csv: the file is "), std::string::npos) << text;
    EXPECT_NE(message.find("run the scene again"), std::string::npos) << text;
  }
}

TEST(Histories, ThinnedOnesKeepEveryPeak) {
  Histories histories;
  histories.columns = {{"a", "m", {}}, {"b", "m", {}}};
  for (int i = 0; i < 10000; ++i) {
    histories.times.push_back(0.001 * i);
    histories.columns[0].values.push_back(i == 5003 ? 7 : std::sin(0.002 * i));
    histories.columns[1].values.push_back(i == 1234 ? -9 : i);
  }
  const Histories thin = thinned(histories, 200);
  EXPECT_EQ(thin.times.size(), 200U);
  EXPECT_TRUE(std::ranges::is_sorted(thin.times));
  EXPECT_EQ(thin.times.front(), histories.times.front());
  EXPECT_EQ(thin.times.back(), histories.times.back());
  EXPECT_EQ(std::ranges::max(thin.columns[0].values), 7);
  EXPECT_EQ(std::ranges::min(thin.columns[1].values), -9);
  EXPECT_EQ(thin.columns[1].values[150], 7500);  // rising: the least comes first
  EXPECT_EQ(thinned(histories, 10000).times, histories.times);
}

}  // namespace
}  // namespace dda
