#include "verification/precision/run_job.h"

#include "verification/precision/bar_run.h"
#include "verification/precision/plane_run.h"

namespace verify {

PrecisionResult run_job(const PrecisionJob& job) {
  return job.problem == Problem::plane ? run_plane(job) : run_bar(job);
}

}  // namespace verify
