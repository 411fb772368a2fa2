// All answers of a small frictional contact problem, by trying every status of every contact.
#pragma once

#include <vector>

#include "verification/fclib/friction_problem.h"

namespace verify {

// Each contact is open, sticks, or slides one way or the other; given these an answer follows from linear equations,
// and it is one where the inequalities hold as well. 4^contacts systems: for a handful of contacts.
[[nodiscard]] std::vector<Eigen::VectorXd> every_answer(const LocalFrictionProblem& problem);

}  // namespace verify
