#include "verification/chapters/tunnel_blast.h"

#include <gtest/gtest.h>

#include <sstream>

#include "verification/chapters/chapters_test_support.h"

namespace verify {
namespace {

std::optional<bool> verdict(const std::vector<TunnelBlastResult>& results, const std::string& id) {
  Chapter chapter;
  judge_tunnel_blast(results, chapter);
  return verdict(chapter, id);
}

// As the thesis describes it.
std::vector<TunnelBlastResult> as_described() {
  TunnelBlastResult result{tunnel_blast_readings().front(), {}};
  for (const double stress : blast_stresses())
    for (const double friction : blast_frictions()) {
      const double strength = (stress > 0 ? 0.5 : 1) * (1 - friction / 100);
      const double roof = stress > 0 ? 2 : 0.5;
      result.outcomes.push_back({friction,
                                 stress,
                                 {strength, roof * strength, 0.4 * strength, 0.3 * strength},
                                 {strength, strength, strength, strength},
                                 1e6 * strength,
                                 2e6 * strength,
                                 friction > 0 ? 0.0 : 1.0,
                                 1});
    }
  return {result};
}

TEST(TunnelBlast, WhatTheThesisDescribesIsConfirmed) {
  for (const char* id : {"6.2-collapse", "6.2-stress", "6.2-distance", "6.2-velocity-friction",
                         "6.2-acceleration-friction", "6.2-wall", "6.2-roof", "6.2-walls"})
    EXPECT_EQ(verdict(as_described(), id), true) << id;
}

TEST(TunnelBlast, WhatIsOtherwiseIsNot) {
  std::vector<TunnelBlastResult> results = as_described();
  for (TunnelBlastOutcome& o : results.front().outcomes) {
    o.roof_end_speed = 1;
    std::swap(o.stress_5, o.stress_6);
    std::swap(o.velocity[0], o.velocity[1]);
    o.acceleration[0] = 1 + o.friction;
    if (o.stress > 0) o.stress_5 *= 10;
    if (o.stress > 0) o.velocity[2] *= 10;
  }
  for (const char* id :
       {"6.2-collapse", "6.2-stress", "6.2-distance", "6.2-acceleration-friction", "6.2-wall", "6.2-roof", "6.2-walls"})
    EXPECT_EQ(verdict(results, id), false) << id;
}

TEST(TunnelBlast, FailedRunsTellNothing) {
  std::vector<TunnelBlastResult> results = as_described();
  results.front().outcomes.clear();
  EXPECT_EQ(verdict(results, "6.2-collapse"), std::nullopt);
  EXPECT_EQ(verdict(results, "6.2-distance"), std::nullopt);
}

// The run with the blast: point 1 is 0.3 m/s faster at 90 ms, point 6 has 2 MPa more; before the blast they differ by
// more, which does not count. Point 2 falls at 1 m/s.
SceneRun example(bool blast) {
  std::ostringstream csv;
  csv << "time [s]";
  for (int point = 1; point <= 4; ++point)
    for (const char* q : {"displacement", "velocity", "acceleration"})
      for (const char* axis : {"x", "y"}) csv << ",point_" << point << "_" << q << "_" << axis << " [SI]";
  csv << ",point_5_xx [Pa],point_5_yy [Pa],point_6_xx [Pa],point_6_yy [Pa]\n";
  for (int ms = 0; ms <= 104; ++ms) {
    const double faster = blast && ms == 90 ? 0.3 : blast && ms == 40 ? 7 : 0;
    csv << 1e-3 * ms << ",0,0,0," << 1 + faster << ",0,0";
    csv << ",0," << -1e-3 * ms << ",0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0";
    csv << ",0,0,0," << (blast && ms > 95 ? -2e6 : 0) << "\n";
  }
  return run_that_left(csv.str());
}

TEST(TunnelBlast, ReadsTheDifferenceThatTheBlastMakes) {
  const TunnelBlastOutcome o = tunnel_blast_outcome(5, 0, example(true), example(false));
  EXPECT_NEAR(o.velocity[0], 0.3, 1e-12);
  EXPECT_EQ(o.velocity[1], 0);
  EXPECT_EQ(o.stress_5, 0);
  EXPECT_NEAR(o.stress_6, 2e6, 1e-6);
  EXPECT_NEAR(o.roof_end_speed, 1, 1e-9);
  EXPECT_NEAR(o.free_fall_speed, 9.81 * 0.1017, 0.005);
}

TEST(TunnelBlast, ScenesWithAndWithoutTheBlastDifferByItsLoad) {
  const TunnelBlastReading reading = tunnel_blast_readings().front();
  SceneFolder::Scene with = tunnel_blast_scene(reading, 5, 50e6, true);
  const SceneFolder::Scene without = tunnel_blast_scene(reading, 5, 50e6, false);
  ASSERT_EQ(with.at("loads").size(), without.at("loads").size() + 1);
  with["loads"].erase(with["loads"].size() - 1);
  with["title"] = without.at("title");
  EXPECT_EQ(with, without);
}

}  // namespace
}  // namespace verify
