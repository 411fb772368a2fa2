// What the first process asks of the others.
#pragma once

#include "engine/linear/pcg_solver.h"

namespace dda {

enum class Task { analyze, factorize, solve, precondition, forget, end };

// Sent byte by byte, between processes of one program on machines of one kind.
struct Order {
  Task task = Task::end;
  int solver = -1;          // each has its number
  int blocks = 0;           // analyze: of the whole matrix
  bool has_guess = false;   // solve: the solution starts from one
  PcgOptions options = {};  // analyze
};

}  // namespace dda
