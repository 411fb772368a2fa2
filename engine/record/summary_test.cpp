#include "engine/record/summary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/core/read_file.h"
#include "engine/record/record_test_support.h"

namespace dda {
namespace {

using nlohmann::json;

EnergyLedger balanced_ledger() {
  EnergyLedger energy;
  energy.initial.kinetic = 2;
  energy.initial.strain = 3;
  energy.initial.contact = 5;
  energy.kinetic = 9;   // +7
  energy.strain = 14;   // +11
  energy.contact = 18;  // +13
  energy.initial.bolts = 37;
  energy.bolts = 78;  // +41
  energy.initial.linings = energy.linings = 61;
  energy.friction = 17;
  energy.plastic = 43;
  energy.radiated = 19;
  energy.dashpot = 53;
  energy.damping = 23;
  energy.numerical = 29;
  energy.law_changes = 7;
  energy.gravity_work = 31;
  energy.removed = 47;
  energy.external_work = 279;  // 7 + 11 + 13 + 41 + 17 + 43 + 19 + 53 + 23 + 29 + 7 + 47 - 31
  return energy;
}

TEST(EnergyLedger, ResidualIsWhatTheTermsDoNotExplain) {
  EnergyLedger energy = balanced_ledger();
  EXPECT_EQ(energy.residual(), 0);
  EXPECT_EQ(energy.scale(), 279);
  energy.gravity_work -= 200;
  EXPECT_EQ(energy.residual(), -200);
  EXPECT_EQ(energy.scale(), 279);
  EXPECT_EQ(energy.relative_residual(), -200.0 / 279);
}

// A load that came and went leaves small terms behind: what was wrong on the way counts by what there was.
TEST(EnergyLedger, GainIsAShareOfTheLargestThereWas) {
  EnergyLedger energy;
  energy.largest = 200;
  energy.numerical = -3;
  EXPECT_EQ(energy.scale(), 200);
  EXPECT_EQ(energy.gain(), 0.015);
  energy.numerical = 3;
  EXPECT_EQ(energy.gain(), -0.015);
  energy.law_changes = -7;
  EXPECT_EQ(energy.gain(), 0.02);
}

TEST(EnergyLedger, NothingHappenedAndNotANumber) {
  EnergyLedger energy;
  EXPECT_EQ(energy.relative_residual(), 0);
  energy.friction = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(energy.relative_residual()));
}

TEST(Summary, HoldsEverything) {
  RunSummary summary;
  summary.status = Status::stopped;
  summary.message = "stopped by the user";
  summary.title = "bar";
  summary.from = "settled:gravity";
  summary.time_s = 0.1;
  summary.steps = 12;
  summary.counters = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  summary.energy = balanced_ledger();
  summary.energy_at_end = {{"gravity", balanced_ledger()}, {"quake", balanced_ledger()}};
  summary.energy_at_end[1].second.radiated += 100;
  summary.cpu_s = 1.5;
  summary.wall_s = 2.5;
  summary.phases = {{"solve", 1.25}, {"assembly", 0.25}};
  summary.stages = {{"gravity", 0, 100, true, 0, 0, "", "static", ""},
                    {"quake", 100, 102.5, false, 1e-5, 1e-3, "blocks of 1 m that fall", "generalized_alpha",
                     "implicit steps, as explicit ones would save too little"}};
  summary.out_of_balance = {{"gravity", 3e-7}};
  summary.loose_blocks.push_back({{"stage", "gravity"}, {"block", "sliver"}});
  summary.energy_release_rates.push_back({{"stage", "quake"}});
  summary.solver = "cholesky";
  summary.blocks = 200;
  summary.contacts = 199;
  summary.penetration = {1e-3, 0.02, {"a", "b"}, 0.05};
  summary.remarks = {"gravity points upwards"};
  summary.histories = {{"histories.csv", 13, {{"at 50 m", "Pa"}}}};
  summary.outputs = {"histories.csv", "frames.pvd"};

  const json read = json::parse(summary_json(summary));
  const json expected = json::parse(R"({
    "status": "stopped", "message": "stopped by the user", "title": "bar", "from": "settled:gravity", "time_s": 0.1, "steps": 12,
    "blocks": 200, "contacts": 199, "solver": "cholesky", "cpu_s": 1.5, "wall_s": 2.5,
    "phases": {"solve": 1.25, "assembly": 0.25},
    "stages": [{"name": "gravity", "begin_s": 0, "end_s": 100, "settles": true, "first_dt_s": 0, "dt_s": 0, "dt_reason": "", "stable_dt_s": null,
                "integrator": "static", "integrator_reason": ""},
               {"name": "quake", "begin_s": 100, "end_s": 102.5, "settles": false, "first_dt_s": 1e-5, "dt_s": 1e-3,
                "dt_reason": "blocks of 1 m that fall", "stable_dt_s": null,
                "integrator": "generalized_alpha", "integrator_reason": "implicit steps, as explicit ones would save too little"}],
    "static_stages": [{"name": "gravity", "out_of_balance": 3e-7}],
    "loose_blocks": [{"stage": "gravity", "block": "sliver"}], "blocks_out_of_balance": [],
    "energy_release_rates": [{"stage": "quake"}], "excess_shear": [],
    "counters": {"steps": 1, "matrix_rebuilds": 2, "analyses": 3, "factorizations": 4, "solves": 5,
      "solver_iterations": 6, "open_close_iterations": 7, "local_passes": 8, "steps_of_given_friction": 9,
      "contact_searches": 10, "contact_state_changes": 11},
    "energy": {"unit": "J per m of thickness", "kinetic": 9.0, "strain": 14.0, "contact": 18.0, "bolts": 78.0, "linings": 61.0,
      "initial_kinetic": 2.0, "initial_strain": 3.0, "initial_contact": 5.0, "initial_bolts": 37.0, "initial_linings": 61.0, "external_work": 279.0,
      "gravity_work": 31.0, "friction": 17.0, "plastic": 43.0, "radiated": 19.0, "dashpot": 53.0, "damping": 23.0, "numerical": 29.0, "law_changes": 7.0,
      "removed": 47.0, "residual": 0.0, "residual_relative": 0.0},
    "energy_released": {"unit": "J per m of thickness", "W": 279.0, "Uc": 65.0, "Ub": -31.0, "Wj": 17.0, "Wp": 43.0,
      "Uk": 7.0, "Wk": 112.0, "Wv": 19.0, "Um": 47.0, "released_by_work": 185.0, "released_by_fate": 185.0,
      "difference_relative": 0.0, "stages": [
      {"stage": "gravity", "unit": "J per m of thickness", "W": 279.0, "Uc": 65.0, "Ub": -31.0, "Wj": 17.0, "Wp": 43.0,
       "Uk": 7.0, "Wk": 112.0, "Wv": 19.0, "Um": 47.0, "released_by_work": 185.0, "released_by_fate": 185.0,
       "difference_relative": 0.0},
      {"stage": "quake", "unit": "J per m of thickness", "W": 0.0, "Uc": 0.0, "Ub": 0.0, "Wj": 0.0, "Wp": 0.0,
       "Uk": 0.0, "Wk": 0.0, "Wv": 100.0, "Um": 0.0, "released_by_work": 0.0, "released_by_fate": 100.0,
       "difference_relative": -1.0}]},
    "deepest_penetration": {"depth_m": 1e-3, "of_smaller_block": 0.02, "blocks": ["a", "b"], "time_s": 0.05},
    "remarks": ["gravity points upwards"],
    "histories": [{"file": "histories.csv", "rows": 13,
      "columns": [{"name": "time", "unit": "s"}, {"name": "at 50 m", "unit": "Pa"}]}],
    "outputs": ["histories.csv", "frames.pvd"]})");
  EXPECT_EQ(read, expected) << json::diff(expected, read);
}

TEST(Summary, HasLiningsWhereThereAreAny) {
  EXPECT_FALSE(json::parse(summary_json({})).contains("linings"));
  RunSummary summary;
  summary.linings = {{{"name", "shotcrete"}}};
  EXPECT_EQ(json::parse(summary_json(summary)).at("linings").at(0).at("name"), "shotcrete");
}

TEST(Summary, OfAnEmptyRunHasAllKeys) {
  const json read = json::parse(summary_json({}));
  EXPECT_EQ(read.at("status"), "ok");
  EXPECT_EQ(read.at("phases"), json::object());
  EXPECT_TRUE(read.at("deepest_penetration").is_null());
  EXPECT_EQ(read.at("histories"), json::array());
  EXPECT_EQ(read.at("outputs"), json::array());
}

TEST(Summary, IsValidJsonWhateverHappened) {
  RunSummary summary;
  summary.energy.kinetic = std::numeric_limits<double>::quiet_NaN();
  summary.message = "line\n\"quoted\" and bytes \xff that are not UTF-8";
  const json read = json::parse(summary_json(summary));
  EXPECT_TRUE(read.at("energy").at("kinetic").is_null());
  EXPECT_EQ(read.at("message"), "line\n\"quoted\" and bytes \xef\xbf\xbd that are not UTF-8");
}

TEST(Summary, IsWrittenWholeOrNotAtAll) {
  const TemporaryFolder folder;
  write_summary(folder / "summary.json", {});
  const std::string first = read_file(folder / "summary.json");
  EXPECT_EQ(first, summary_json({}));
  RunSummary next;
  next.title = "next";
  {
    const FullDisk full(50);
    EXPECT_THROW(write_summary(folder / "summary.json", next), std::runtime_error);
  }
  EXPECT_EQ(read_file(folder / "summary.json"), first);
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"summary.json"});
}

}  // namespace
}  // namespace dda
