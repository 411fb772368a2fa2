// Damaged sweeps are read to jobs of finite numbers, no more than are allowed, or refused in one sentence.
#include <cmath>
#include <string>
#include <vector>

#include "engine/core/fuzz_support.h"
#include "engine/core/read_file.h"
#include "engine/core/temporary_folder.h"
#include "engine/record/atomic_file.h"
#include "verification/sweep/grid.h"
#include "verification/sweep/job.h"
#include "verification/sweep/plots.h"
#include "verification/sweep/spec.h"
#include "verification/sweep/sweep_folder.h"
#include "verification/sweep/table.h"

namespace verify {
namespace {

const std::vector<std::string>& corpus() {
  static const std::vector<std::string> specs{dda::read_file(DDA_SWEEPS "/small.json"),
                                              dda::read_file(DDA_SWEEPS "/eta.json"),
                                              R"({"title": "all keys", "closed_form": false, "grid": [
  {"eta": [0.1, 0.25], "cfl": [0.5, 1], "law": ["classical"], "spring_over_young": [5, 10], "shear_to_normal": [0.4],
   "integrator": ["thesis", {"hht": 0.1}], "poisson": [0, 0.25], "strain_inertia": [1], "pulse": ["cycle", "tone"]},
  {"eta": [0.1], "cfl": [0.5], "law": ["cubic"], "lateral_inertia": [true, false], "correct_time_dispersion": [false],
   "integrator": ["trapezoidal", {"generalized_alpha": 0.8}]},
  {"eta": [0.2], "cfl": [2], "law": ["consistent"], "penalty": [4, 8]}],
 "plots": [{"x": "eta", "y": "cfl"}, {"x": "eta"}]})"};
  return specs;
}

void expect_finite(const JobParameters& job) {
  const auto parameters = to_json(job);
  for (const auto& [name, value] : parameters.items()) {
    EXPECT_FALSE(value.is_null()) << name;
    EXPECT_TRUE(!value.is_number() || std::isfinite(value.get<double>())) << name << " is " << value.dump();
  }
  EXPECT_GT(job.dt, 0);
  EXPECT_GT(job.block_length, 0);
}

TEST(SpecFuzz, DamagedSweeps) {
  const auto tally = dda::fuzz({.inputs = 3000}, [](dda::Mutator& mutator) {
    const SweepSpec spec = parse_spec(mutator.text(mutator.one_of(corpus())), "sweep.json");
    EXPECT_FALSE(spec.jobs.empty());
    EXPECT_LE(spec.jobs.size(), most_jobs);
    for (const JobParameters& job : spec.jobs) expect_finite(job);
    for (const SweepPlot& plot : spec.plots) EXPECT_FALSE(groups_of(spec, plot).empty());
  });
  dda::expect_both(tally);
}

// A job's file that is not whole counts as missing.
TEST(SpecFuzz, DamagedFilesOfJobs) {
  const dda::TemporaryFolder temporary;
  const SweepFolder folder(temporary.path());
  const SweepSpec spec = parse_spec(corpus()[0], "sweep.json");
  folder.prepare(corpus()[0]);
  folder.write(0, {"ok", "", to_json(spec.jobs[0]), to_json(JobResult{})});
  const std::string whole = dda::read_file(folder.job_file(0));
  const auto tally = dda::fuzz({.inputs = 1000}, [&](dda::Mutator& mutator) {
    dda::write_file(folder.job_file(0), mutator.text(whole));
    const JobFile job = folder.read(0, spec.jobs[0]);
    const std::vector<JobFile> jobs(spec.jobs.size(), job);
    EXPECT_FALSE(to_csv(spec, jobs).empty());
    EXPECT_FALSE(summary_of(jobs).empty());
    if (job.status == "missing") throw dda::InputError("", "the job's file", "damaged", "to be whole");
  });
  dda::expect_both(tally);
}

}  // namespace
}  // namespace verify
