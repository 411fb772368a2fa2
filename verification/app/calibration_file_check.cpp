// Reads what `dda-verify calibrate` wrote, as anybody else would.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <tuple>

namespace {

using Json = nlohmann::json;

const std::filesystem::path folder = CALIBRATION_FOLDER;

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

class CalibrationFile : public testing::Test {
 protected:
  Json json_ = Json::parse(text_of(folder / "calibration.json"));
};

TEST_F(CalibrationFile, HasEveryRowOnce) {
  std::set<std::tuple<std::string, double, double>> rows;
  for (const Json& row : json_.at("rows"))
    rows.emplace(row.at("scheme").get<std::string>(), row.at("dt_s").get<double>(),
                 row.at("block_length_m").get<double>());
  EXPECT_EQ(rows.size(), json_.at("rows").size());
  for (const char* scheme : {"thesis", "accurate", "accurate_strip", "consistent", "classical_trapezoidal"})
    for (const double dt : {1e-5, 1e-4})
      for (const double length : {0.5, 1.0, 2.0, 5.0, 10.0})
        EXPECT_TRUE(rows.contains({scheme, dt, length})) << scheme << " " << dt << " " << length;
}

TEST_F(CalibrationFile, OnlyComparisonsWithThePrintMayBeNull) {
  for (const Json& row : json_.at("rows"))
    for (const auto& [key, value] : row.items())
      EXPECT_TRUE(!value.is_null() || (row.at("scheme") != "thesis" && key.ends_with("_vs_thesis_pct"))) << key;
}

TEST_F(CalibrationFile, NumbersFitTogether) {
  for (const Json& row : json_.at("rows")) {
    const double error = 100 * (row.at("amplitude_kpa").get<double>() / 1000 - 1);
    EXPECT_NEAR(row.at("amplitude_error_pct"), error, 1e-9);
    EXPECT_NEAR(row.at("eta"), row.at("block_length_m").get<double>() / 43.4372, 1e-5);
    EXPECT_EQ(row.at("steps"), std::lround(0.035 / row.at("dt_s").get<double>()));
    EXPECT_GT(row.at("cpu_s"), 0);
  }
}

// The twenty printed numbers within 0.5 %, and every other promise the program judged itself.
TEST_F(CalibrationFile, PromisesAreKept) {
  int printed = 0;
  for (const Json& row : json_.at("rows")) {
    if (row.at("scheme") != "thesis") continue;
    printed += 2;
    EXPECT_NEAR(row.at("amplitude_kpa").get<double>() / row.at("thesis_amplitude_kpa").get<double>(), 1, 0.005);
    EXPECT_NEAR(row.at("velocity_onset_m_s").get<double>() / row.at("thesis_velocity_m_s").get<double>(), 1, 0.005);
  }
  EXPECT_EQ(printed, 20);
  for (const Json& promise : json_.at("promises")) EXPECT_TRUE(promise.at("kept")) << promise.at("claim");
}

TEST(CalibrationReport, IsOnePageWithItsFigures) {
  const std::string html = text_of(folder / "calibration.html");
  std::size_t figures = 0;
  for (std::size_t at = html.find("<svg"); at != std::string::npos; at = html.find("<svg", at + 1)) ++figures;
  EXPECT_EQ(figures, 5U);
  for (const char* foreign : {"<script", "<img", "<link", "src=", "@import"})
    EXPECT_EQ(html.find(foreign), std::string::npos) << foreign;
  for (const char* part : {"Table 3.2", "Table 3.3", "Fig. 3.2", "Fig. 3.3", "Fig. 3.4", "Fig. 3.5"}) {
    EXPECT_NE(html.find(part), std::string::npos) << part;
    EXPECT_NE(text_of(folder / "calibration.md").find(part), std::string::npos) << part;
  }
}

}  // namespace
