// `dda spectrum`: from a run to a table, and what it refuses.
#include <cmath>
#include <numbers>
#include <string>

#include "engine/app/command_line_test_support.h"
#include "engine/record/csv.h"

namespace dda {
namespace {

class Spectrum : public CommandLine {
 protected:
  // A block that is moved by a sine of acceleration, 3 m/s2 and 10 Hz, for 1 s.
  void run_shaker() const {
    ASSERT_EQ(run_scene(R"({"dda": 1, "materials": {"rock": {"density": 2600, "young": "10 GPa", "poisson": 0.2}},
 "joints": {"default": {"bonded": true}},
 "blocks": [{"polygon": {"name": "base", "vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}},
            {"polygon": {"name": "top", "vertices": [[0, 1], [1, 1], [1, 2], [0, 2]]}}],
 "supports": [{"block": "base", "acceleration": [3, 0], "history": {"sine": {"frequency": "10 Hz", "cycles": 10}}}],
 "measurements": [{"name": "a", "quantity": "acceleration_x", "block": "base"},
                  {"name": "v", "quantity": "velocity_x", "block": "base"},
                  {"name": "u", "quantity": "displacement_x", "block": "base"},
                  {"name": "still", "quantity": "velocity_y", "block": "base"},
                  {"name": "force", "quantity": "stress_xx", "block": "top"}],
 "steps": {"dt": "1 ms", "duration": "1 s", "kinematics": "small"}})",
                        "results")
                  .code,
              0);
  }

  [[nodiscard]] std::vector<std::vector<double>> rows_of(const std::string& name) const {
    const std::string file = text(name);
    std::string_view rest = file;
    [[maybe_unused]] const auto head = take_csv_row(rest);
    std::vector<std::vector<double>> rows;
    while (!rest.empty()) {
      rows.emplace_back();
      for (const std::string& cell : take_csv_row(rest)) rows.back().push_back(csv_number(cell).value());
    }
    return rows;
  }
};

// At resonance the swing of 2 % damping grows as (1 - exp(-r w t))/(2 r) of the static one.
TEST_F(Spectrum, OfAShakenBlock) {
  run_shaker();
  const Outcome outcome = call({"spectrum", path("results"), "--measurement", "a", "--damping", "5 %,0.02", "--periods",
                                "10 ms,1", "--count", "3"});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_TRUE(contains(outcome.out, "spectrum.csv: 3 periods from 0.01 to 1 s\ndamping 5 %: Sa is largest at 0.1 s"));
  EXPECT_EQ(lines(outcome.out), 3);
  EXPECT_TRUE(text("results/spectrum.csv")
                  .starts_with("period [s],frequency [Hz],Sd 5 % [m],Sv 5 % [m/s],Sa 5 % [m/s2],Sd 2 % [m],"));
  const auto rows = rows_of("results/spectrum.csv");
  ASSERT_EQ(rows.size(), 3U);
  const double omega = 20 * std::numbers::pi;
  for (const auto& [place, ratio] : {std::pair(4, 0.05), std::pair(7, 0.02)}) {
    const double expected = 3 * (1 - std::exp(-ratio * omega)) / (2 * ratio);
    EXPECT_NEAR(rows[1][static_cast<std::size_t>(place)], expected, 0.01 * expected);  // of the last peak's place
  }
  for (const auto& row : rows) {
    EXPECT_NEAR(row[3], row[2] * 2 * std::numbers::pi / row[0], 1e-12 * row[3]);
    EXPECT_NEAR(row[4], row[3] * 2 * std::numbers::pi / row[0], 1e-12 * row[4]);
  }
}

TEST_F(Spectrum, OfWhatDoesNotMoveHasNoPeak) {
  run_shaker();
  const Outcome outcome = call({"spectrum", path("results"), "--measurement", "still"});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_TRUE(contains(outcome.out, "damping 5 %: Sa is 0 at all periods, as nothing moves in the measurement\n"))
      << outcome.out;
}

// Straight lines between rows of 1 ms, at periods of 50 ms and more: (2 pi dt/T)^2/12 of the motion, 1.3e-3.
TEST_F(Spectrum, IsTheSameOfAccelerationVelocityAndDisplacement) {
  run_shaker();
  for (const std::string name : {"a", "v", "u"})
    ASSERT_EQ(call({"spectrum", path("results"), "--measurement", name, "--periods", "0.05,1", "--count", "20", "--out",
                    path(name + ".csv")})
                  .code,
              0);
  const auto expected = rows_of("a.csv");
  for (const std::string name : {"v", "u"}) {
    const auto rows = rows_of(name + ".csv");
    ASSERT_EQ(rows.size(), expected.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      EXPECT_NEAR(rows[i][4], expected[i][4], 3e-3 * expected[i][4]) << name << " " << rows[i][0];
  }
}

// What static stages move, here by some 1e-4 m before and between two of 0.5 s that shake, takes no time and is no
// motion of the ground: read as one it would make oscillators of 50 ms swing by as much. Of the velocity only the
// second is known, which begins anew at zero.
TEST_F(Spectrum, LeavesOutWhatStaticStagesMove) {
  ASSERT_EQ(run_scene(R"({"dda": 1, "materials": {"rock": {"density": 2600, "young": "0.2 GPa", "poisson": 0.2}},
 "joints": {"default": {"bonded": true}}, "gravity": [400, -9.81],
 "blocks": [{"polygon": {"name": "base", "vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}},
            {"polygon": {"name": "top", "vertices": [[0, 1], [1, 1], [1, 2], [0, 2]]}}],
 "supports": [{"block": "base", "acceleration": [3, 0], "history": {"sine": {"frequency": "10 Hz", "cycles": 10}}}],
 "loads": [{"edge": "top", "force": ["1 MN", 0], "from_stage": "loaded"}],
 "measurements": [{"name": "v", "quantity": "velocity_x", "block": "top"},
                  {"name": "u", "quantity": "displacement_x", "block": "top"}],
 "steps": [{"name": "weight", "integrator": "static", "kinematics": "small"},
           {"dt": "1 ms", "duration": "0.5 s", "kinematics": "small"},
           {"name": "loaded", "integrator": "static", "kinematics": "small"},
           {"dt": "1 ms", "duration": "0.5 s", "kinematics": "small"}]})",
                      "results")
                .code,
            0);
  const auto spectrum_of = [&](const std::string& name) {
    const Outcome outcome = call({"spectrum", path("results"), "--measurement", name, "--periods", "0.05,1", "--count",
                                  "20", "--out", path(name + ".csv")});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    return rows_of(name + ".csv");
  };
  const auto expected = spectrum_of("v"), rows = spectrum_of("u");
  ASSERT_EQ(rows.size(), expected.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_NEAR(rows[i][4], expected[i][4], 5e-3 * expected[i][4]) << rows[i][0];
}

TEST_F(Spectrum, SaysWhatTheRowsDoNotResolve) {
  run_shaker();
  EXPECT_TRUE(contains(call({"spectrum", path("results"), "--measurement", "a"}).out, "100 periods from 0.01 to 1 s"));
  const Outcome outcome = call({"spectrum", path("results"), "--measurement", "a", "--periods", "1ms,3s"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(contains(outcome.out, "below 0.01 s a period has less than ten rows of histories.csv"));
  EXPECT_TRUE(contains(outcome.out, "above 1 s a period takes longer than the measurement"));
}

TEST_F(Spectrum, Refuses) {
  run_shaker();
  const auto refuse = [&](const std::vector<std::string>& options, std::string_view part) {
    std::vector<std::string> arguments = {"spectrum", path("results")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expect_refusal(arguments, part);
  };
  refuse({}, "--measurement is required");
  refuse({"--measurement", "b"},
         "--measurement is \"b\", expected a displacement, velocity or acceleration of the run");
  refuse({"--measurement", "force"}, "--measurement is \"force\" in Pa, expected a displacement");
  for (const char* bad : {"1", "-0.1", "nan", "x", "0.05,2", "0.05,5 %"})
    refuse({"--measurement", "a", "--damping", bad}, "--damping");
  for (const char* bad : {"", "1", "2,1", "0,1", "1,2,3", "1Hz,2Hz", "-1,1", "1e-300,1"})
    refuse({"--measurement", "a", "--periods", bad}, "--periods");
  for (const char* bad : {"", "0", "1", "1.5", "1e9", "ten"}) refuse({"--measurement", "a", "--count", bad}, "--count");
  refuse({"--measurement", "a", "--out", path("results")}, "--out");
  for (const char* own :
       {"results/histories.csv", "results/peaks.csv", "results/summary.json", "results/checkpoint.bin"})
    refuse({"--measurement", "a", "--out", path(own)}, "expected a name that ends in .csv and is none of a run's own");
  expect_refusal({"spectrum", path("nothing"), "--measurement", "a"}, "histories.csv: the file is missing");
  write("results/histories.csv", "time [s],a [m/s2]\n0,0\n1,0\n");
  refuse({"--measurement", "a"}, "the number of rows in motion is 2, expected more than ten");
  write("results/histories.csv", "time [s],a [m/s2]\n0,0\n1,nan\n");
  refuse({"--measurement", "a"}, "measurement \"a\" is not finite everywhere");
  EXPECT_FALSE(exists("results/spectrum.csv"));
}

}  // namespace
}  // namespace dda
