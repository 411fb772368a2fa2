// What a sweep's file means, and what is told of one that is wrong.
#include "verification/sweep/spec.h"

#include <gtest/gtest.h>

#include "engine/core/error.h"
#include "verification/sweep/plots.h"
#include "verification/thesis/reference.h"

namespace verify {
namespace {

std::vector<JobParameters> jobs(const std::string& grid) { return parse_spec(R"({"grid": )" + grid + "}", "s").jobs; }

std::string complaint(const std::string& text) {
  try {
    static_cast<void>(parse_spec(text, "s.json"));
  } catch (const dda::InputError& error) {
    return error.what();
  }
  return "none";
}

std::string complaint_of_grid(const std::string& grid) { return complaint(R"({"grid": )" + grid + "}"); }

TEST(Spec, IsEveryCombinationTheLastKeyFastest) {
  const auto all =
      jobs(R"({"dt": [1e-5, "0.1 ms"], "block_length": [1, 2, 5], "integrator": ["thesis", {"hht": 0.1}]})");
  ASSERT_EQ(all.size(), 12U);
  EXPECT_EQ(all[0].integrator_name, "thesis");
  EXPECT_EQ(all[1].integrator_name, "hht 0.1");
  EXPECT_EQ(all[1].stage.integrator.alpha_f, 0.1);
  EXPECT_EQ(all[2].dt, 1e-4);
  EXPECT_EQ(all[2].block_length, 1);
  EXPECT_EQ(all[11].block_length, 5);
}

TEST(Spec, EtaAndCflAreThoseOfTheThesis) {
  const JobParameters job = jobs(R"({"eta": [0.125], "cfl": [0.5]})").front();
  EXPECT_NEAR(job.block_length, 43.4372 / 8, 1e-4);  // a wavelength of 43.437 m
  EXPECT_NEAR(job.dt, 0.5 * job.block_length / 4343.72, 1e-9);
  EXPECT_NEAR(job.eta(), 0.125, 1e-12);
  EXPECT_NEAR(job.cfl(), 0.5, 1e-12);
}

TEST(Spec, DefaultsAreTheThesisScheme) {
  const JobParameters job = jobs(R"({"block_length": [2], "dt": [1e-4]})").front();
  EXPECT_EQ(job.joint.law, dda::InterfaceLaw::classical);
  EXPECT_EQ(job.joint.spring_over_young, 10);
  EXPECT_EQ(job.stage.integrator.beta, 0.5);
  EXPECT_EQ(job.stage.integrator.gamma, 1);
  EXPECT_EQ(job.poisson, 0.25);
}

TEST(Spec, GridsFollowEachOther) {
  const auto all = jobs(R"([{"eta": [0.1], "cfl": [1]}, {"eta": [0.2, 0.3], "cfl": [1], "law": ["cubic"]}])");
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].joint.law, dda::InterfaceLaw::classical);
  EXPECT_EQ(all[2].joint.law, dda::InterfaceLaw::cubic);
}

TEST(Spec, MistakesAreToldInASentence) {
  EXPECT_EQ(complaint("[1]"), "s.json: the sweep is [1], expected an object");
  EXPECT_EQ(complaint("{}"), "s.json: grid is missing, expected a value");
  EXPECT_NE(complaint(R"({"grid": {"eta": [0.1], "cfl": [1]}, "plot": 1})").find("plot is 1, expected"),
            std::string::npos);
  EXPECT_NE(complaint_of_grid(R"({"eta": [0.1], "clf": [1]})").find("grid.clf is [1], expected to be a parameter"),
            std::string::npos);
  EXPECT_NE(complaint_of_grid(R"({"eta": [0.1], "cfl": [1], "dt": [1]})").find("both"), std::string::npos);
  EXPECT_NE(complaint_of_grid(R"({"cfl": [1]})").find("one of the keys \"eta\" and \"block_length\""),
            std::string::npos);
  EXPECT_EQ(complaint_of_grid(R"({"eta": [0.1, 0.9], "cfl": [1]})"),
            "s.json: grid.eta[1] is 0.9, expected a number from 0.0001 to 0.6");
  EXPECT_EQ(complaint_of_grid(R"({"eta": [0.1], "cfl": [0]})"), "s.json: grid.cfl[0] is 0, expected a positive number");
  EXPECT_EQ(complaint_of_grid(R"({"eta": [], "cfl": [1]})"), "s.json: grid.eta is [], expected at least one value");
  EXPECT_NE(complaint_of_grid(R"({"eta": [0.1], "cfl": [1], "law": ["cubc"]})").find("perhaps \"cubic\""),
            std::string::npos);
  EXPECT_NE(complaint_of_grid(R"({"eta": [0.1], "cfl": [1], "law": ["cubic", "consistent"], "penalty": [4]})")
                .find("to be left out unless every \"law\" of the grid is \"consistent\""),
            std::string::npos);
  EXPECT_NE(complaint(R"({"grid": {"eta": [0.1], "cfl": [1]}, "plots": [{"x": "eta", "y": "dt"}]})")
                .find("plots[0].y is \"dt\", expected a parameter that every grid lists"),
            std::string::npos);
}

TEST(Spec, PlotsArePartedByWhatTheirAxesAreNot) {
  const SweepSpec spec = parse_spec(R"({"grid": [{"eta": [0.1, 0.2], "cfl": [1, 2]},
    {"eta": [0.1, 0.2], "cfl": [1, 2], "law": ["cubic"], "lateral_inertia": [false]}]})",
                                    "s");
  const auto planes = groups_of(spec, {"eta", "cfl"});
  ASSERT_EQ(planes.size(), 2U);
  EXPECT_EQ(planes[0].title, "law classical");
  EXPECT_EQ(planes[1].jobs, (std::vector<std::size_t>{4, 5, 6, 7}));
  const auto lines = groups_of(spec, {"eta", ""});
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[1].title, "cfl 2, law classical");
  EXPECT_EQ(lines[1].jobs, (std::vector<std::size_t>{1, 3}));
}

}  // namespace
}  // namespace verify
