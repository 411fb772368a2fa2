#include "verification/thesis/blast_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "verification/study/markdown.h"
#include "verification/thesis/blast_report.h"

namespace verify {
namespace {

// To 15 m each way, until H1 and V1 have passed.
const BlastStudy& small_study() {
  static const BlastStudy study = run_blast_study(thesis_blast(), {{1, 1}, 3.5e-3, {4e-3}, 0});
  return study;
}

const BlastResult& result(const std::string& name) {
  const auto& all = small_study().results;
  return *std::ranges::find(all, name, &BlastResult::name);
}

TEST(BlastScene, CoversItsRectangleButForTheOctagon) {
  const ThesisBlast& blast = thesis_blast();
  BlastRun run;
  run.dt = 1e-5;
  run.duration = 1e-3;
  run.pulse = equation_18(blast);
  const dda::Model model = blast_scene(blast, run);
  double area = 0;
  for (const dda::Block& block : model.blocks) area += block.moments.area;
  const double octagon = 2 * (1 + std::sqrt(2.0)) * blast.octagon_edge * blast.octagon_edge;
  const double half_width = blast.octagon_width() / 2 + 6 + 8 * 8;
  EXPECT_NEAR(area, 2 * half_width * 2 * (7 + 5 * 8) - octagon, 1e-8 * area);
  ASSERT_EQ(model.edge_loads.size(), 8U);
  for (const dda::EdgeLoad& load : model.edge_loads) {
    EXPECT_NEAR((load.to - load.from).norm(), 1, 1e-12);
    EXPECT_NEAR(load.traction.norm(), 10e6, 1e-6);
  }
  double around = 0;
  for (const dda::ViscousEdge& edge : model.viscous_edges) around += (edge.to - edge.from).norm();
  EXPECT_NEAR(around, 4 * (half_width + 47), 1e-8);
  EXPECT_EQ(model.measurements.size(), 18U);  // nine points
}

// Half as long inside: a quarter of the hole's area stays open, and the faces bear what the hole's wall does.
TEST(BlastScene, ElementFillsTheHoleAndBearsTheSameForce) {
  const ThesisBlast& blast = thesis_blast();
  BlastRun run;
  run.dt = 1e-5;
  run.duration = 1e-3;
  run.pulse = equation_18(blast);
  run.mesh = {1, 1};
  const auto area = [&](bool element) {
    run.element = element;
    double sum = 0;
    for (const dda::Block& block : blast_scene(blast, run).blocks) sum += block.moments.area;
    return sum;
  };
  const double octagon = 2 * (1 + std::sqrt(2.0)) * blast.octagon_edge * blast.octagon_edge;
  EXPECT_NEAR(area(true) - area(false), 0.75 * octagon, 1e-9 * octagon);
  run.element = true;
  const dda::Model model = blast_scene(blast, run);
  ASSERT_EQ(model.edge_loads.size(), 8U);
  for (const dda::EdgeLoad& load : model.edge_loads)
    EXPECT_NEAR(load.traction.norm() * (load.to - load.from).norm(), 10e6, 1e-3);  // N/m, round-off
}

// Blocks of the element part and push on the rock behind them: what reaches H1 and V1 is what the wall's pressure
// makes, but for their inertia and for what their own joints take aside. Measured: 1.19 and 1.04 times, 0.11 and 0.15
// ms later; a face that bore no force, or one that bore it on the length of the outer edge, would halve or double it.
TEST(BlastStudy, ElementHandsOnItsForce) {
  for (const auto& [point, share] : {std::pair(0U, 1.19), std::pair(1U, 1.04)}) {
    const BlastReading& element = result("element").readings[point];
    const BlastReading& dry = result("dry").readings[point];
    EXPECT_NEAR(element.peak_stress / dry.peak_stress, share, 0.05);
    EXPECT_NEAR(element.peak_time - dry.peak_time, 0.13e-3, 0.05e-3);
  }
}

TEST(BlastStudy, PressureIsEquation18) {
  const ThesisBlast& blast = thesis_blast();
  const double arrival = blast_arrival_time(blast);
  const BlastPulse pulse = equation_18(blast);
  EXPECT_EQ(blast_factor(pulse, 1.09 * arrival), 0);
  EXPECT_NEAR(blast_factor(pulse, 1.1 * arrival + blast_rise), 1, 1e-12);
  EXPECT_NEAR(blast_factor(pulse, 2.1 * arrival + blast_rise), std::exp(-1), 1e-12);
}

// A model at rest stays at rest: nothing to subtract. H1 at 5 m is level, V1 at 4 m upright. Printed 8.17/5.14 = 1.59;
// in solid rock about sqrt(5/4). Dry joints keep the load of the 1 m face in the row of 2 m and the column of 1 m. The
// axisymmetric wave has the printed level stress and time. (One test, as the runs take a second.)
TEST(BlastStudy, DryJointsMakeTheUprightStressTheLargerOne) {
  const BlastStudy& study = small_study();
  for (const BlastResult& each : study.results) EXPECT_EQ(each.largest_without, 0) << each.name;
  ASSERT_EQ(study.points.front().point, "H1");
  ASSERT_EQ(study.points.at(1).point, "V1");
  const auto ratio = [](const BlastResult& r) { return r.readings[1].peak_stress / r.readings[0].peak_stress; };
  EXPECT_NEAR(ratio(result("dry")), 1.59, 0.08);  // 5 %: measured 1.64
  EXPECT_NEAR(ratio(result("axisymmetric")), std::sqrt(1.25), 0.03);
  EXPECT_NEAR(result("axisymmetric").readings[0].peak_stress, thesis_blast().level_stress,
              0.02 * thesis_blast().level_stress);
  EXPECT_NEAR(result("axisymmetric").readings[0].peak_time, 1.96e-3, 0.02e-3);  // printed: 1.96 ms
  // A slower decay brings both stresses to the printed ones: measured 8 % below and 4 % above.
  const DecayResult& slow = study.decays.at(0);
  EXPECT_NEAR(slow.level.peak_stress / thesis_blast().level_stress, 1, 0.1);
  EXPECT_NEAR(slow.upright.peak_stress / thesis_blast().upright_stress, 1, 0.1);
}

TEST(BlastReport, NamesEveryRunAndPoint) {
  const std::string page = to_markdown(blast_report(thesis_blast(), small_study()));
  for (const BlastResult& each : small_study().results) EXPECT_NE(page.find("`" + each.name + "`"), std::string::npos);
  for (const char* text : {"H1, 5 m", "V1, 4 m", "1.96", "5.14", "8.17"}) EXPECT_NE(page.find(text), std::string::npos);
}

}  // namespace
}  // namespace verify
