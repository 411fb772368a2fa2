// A few rows of the study: the ones that are cheap enough for every build, also with sanitizers.
#include "verification/thesis/calibration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "verification/harness/histories.h"
#include "verification/thesis/bar_scene.h"
#include "verification/thesis/calibration_json.h"
#include "verification/thesis/closed_form.h"
#include "verification/thesis/promises.h"

namespace verify {
namespace {

constexpr double oracle_limit = 1e-9;  // of the peak: the project's promise; measured 1e-13

TEST(Calibration, ThesisRowAgreesWithThePrint) {
  const CalibrationRow row = calibrate_row(scheme_settings("thesis"), 1e-4, 2);
  EXPECT_LT(std::abs(row.amplitude_vs_thesis_pct().value()), 0.5);
  EXPECT_LT(std::abs(row.velocity_vs_thesis_pct().value()), 0.5);
  EXPECT_NEAR(row.amplitude() / 1e3, 891.1, 0.05);  // the prototype's number, a decimal printed
  EXPECT_NEAR(row.picks.onset_velocity, 4542.7, 0.05);
  EXPECT_LT(row.oracle_max_rel_diff, oracle_limit);
  EXPECT_EQ(row.factorizations, 1);
  EXPECT_EQ(row.matrix_rebuilds, 1);
}

TEST(Calibration, AccurateRowIsAccurate) {
  const CalibrationRow row = calibrate_row(scheme_settings("accurate"), 1e-4, 2);
  EXPECT_LT(std::abs(row.amplitude_error_pct()), 0.2);    // promised: 1; measured 0.07
  EXPECT_LT(std::abs(row.correlation_error_pct()), 0.1);  // promised: 0.7; measured 0.01
  EXPECT_LT(row.oracle_max_rel_diff, oracle_limit);
  EXPECT_FALSE(row.amplitude_vs_thesis_pct().has_value());
}

TEST(Calibration, EverySchemeAgreesWithItsClosedForm) {
  for (const std::string_view name : scheme_names()) {
    const CalibrationRow row = calibrate_row(scheme_settings(name), 1e-4, 10);
    EXPECT_LT(row.oracle_max_rel_diff, oracle_limit) << name;
    EXPECT_LT(row.energy_residual_rel, 1e-9) << name;
  }
}

// The oracle must notice what it is there for: 1e-6 of stiffness, and another integrator.
TEST(ClosedForm, NoticesADifferentProblem) {
  const ThesisBar& bar = thesis_reference().bar;
  const SchemeSettings scheme = scheme_settings("classical_trapezoidal");
  const BarRun run{1e-4, 10, bar.length, 0.02};
  dda::Model model = bar_scene(bar, scheme, run);
  const std::vector<double> exact = closed_form_history(model, bar);
  model.joints.front().spring_over_young *= 1 + 1e-6;
  EXPECT_GT(largest_difference(closed_form_history(model, bar), exact), 1e-8);
  model.joints.front().spring_over_young = 10;
  model.stages.front().integrator.beta += 1e-6;
  EXPECT_GT(largest_difference(closed_form_history(model, bar), exact), 1e-9);
}

TEST(ClosedForm, EngineAndOracleMeanTheSameIntegrators) {
  const auto expect_same = [](const dda::Integrator& engine, const exact::TimeScheme& scheme) {
    EXPECT_DOUBLE_EQ(engine.beta, scheme.beta);
    EXPECT_DOUBLE_EQ(engine.gamma, scheme.gamma);
    EXPECT_DOUBLE_EQ(engine.alpha_m, scheme.alpha_m);
    EXPECT_DOUBLE_EQ(engine.alpha_f, scheme.alpha_f);
  };
  expect_same(dda::thesis_integrator(), exact::thesis_scheme());
  expect_same(dda::trapezoidal_integrator(), exact::trapezoidal());
  expect_same(dda::hht_integrator(0.1), exact::hht(0.1));
  expect_same(dda::generalized_alpha_integrator(0.8), exact::generalized_alpha(0.8));
}

TEST(BarScene, PointMustBeAJoint) {
  const ThesisBar& bar = thesis_reference().bar;
  EXPECT_EQ(block_right_of_point(bar, 2), 25);
  EXPECT_THROW((void)block_right_of_point(bar, 4), std::invalid_argument);
}

TEST(Schemes, UnknownNameIsRefused) { EXPECT_THROW((void)scheme_settings("best"), std::invalid_argument); }

class TwoRows : public testing::Test {
 protected:
  static Calibration two_rows() {
    Calibration calibration;
    calibration.bar = thesis_reference().bar;
    calibration.time_steps = {1e-4};
    calibration.block_lengths = {5};
    for (const char* scheme : {"thesis", "accurate"})
      calibration.rows.push_back(calibrate_row(scheme_settings(scheme), 1e-4, 5));
    calibration.rows[0].cpu_s = 2e-3;
    calibration.rows[1].cpu_s = 1e-3;
    return calibration;
  }

  static std::vector<std::string> failures(const Calibration& calibration) {
    std::vector<std::string> all;
    for (const Promise& promise : judge(calibration))
      all.insert(all.end(), promise.failures.begin(), promise.failures.end());
    return all;
  }

  Calibration calibration_ = two_rows();
};

TEST_F(TwoRows, KeepsItsPromises) { EXPECT_TRUE(failures(calibration_).empty()); }

TEST_F(TwoRows, EachBrokenPromiseNamesItsRow) {
  CalibrationRow& thesis = calibration_.rows[0];
  CalibrationRow& accurate = calibration_.rows[1];
  thesis.picks.half_range *= 1.01;
  accurate.picks.first_peak *= 1.02;
  accurate.picks.correlation_velocity *= 0.98;
  accurate.cpu_s = 3e-3;
  thesis.oracle_max_rel_diff = 2e-9;
  thesis.energy_residual_rel = std::nan("");
  accurate.factorizations = 2;
  calibration_.oracle.push_back({"consistent", "trapezoidal", 1e-4, 5, 2e-9});
  const std::vector<std::string> broken = failures(calibration_);
  EXPECT_EQ(broken.size(), 8U);
  EXPECT_EQ(std::ranges::count_if(broken,
                                  [](const std::string& text) {
                                    return text.starts_with(
                                        "thesis, dt = 0.0001 s, "
                                        "blocks of 5 m: ");
                                  }),
            3);
}

// Exactly the keys that others read come first, in this order; further ones may follow.
TEST_F(TwoRows, JsonHasTheKeysInOrder) {
  const auto json = nlohmann::ordered_json::parse(to_json(calibration_, judge(calibration_)));
  const std::vector<std::string> keys = {"scheme",
                                         "dt_s",
                                         "block_length_m",
                                         "eta",
                                         "amplitude_kpa",
                                         "amplitude_error_pct",
                                         "velocity_onset_m_s",
                                         "velocity_xcorr_m_s",
                                         "velocity_xcorr_error_pct",
                                         "thesis_amplitude_kpa",
                                         "thesis_velocity_m_s",
                                         "amplitude_vs_thesis_pct",
                                         "velocity_vs_thesis_pct",
                                         "oracle_max_rel_diff",
                                         "steps",
                                         "cpu_s",
                                         "factorizations",
                                         "matrix_rebuilds",
                                         "solver_iterations",
                                         "energy_residual_rel"};
  ASSERT_EQ(json.at("rows").size(), 2U);
  for (const auto& row : json.at("rows")) {
    auto item = row.begin();
    for (const std::string& key : keys) EXPECT_EQ((item++).key(), key);
  }
  EXPECT_TRUE(json["rows"][0]["amplitude_vs_thesis_pct"].is_number());
  EXPECT_TRUE(json["rows"][1]["amplitude_vs_thesis_pct"].is_null());
  EXPECT_EQ(json["rows"][1]["thesis_amplitude_kpa"], 870.3);
}

}  // namespace
}  // namespace verify
