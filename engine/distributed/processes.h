// A program of several processes: the first runs it as if it were alone, the others wait for what its solver asks.
#pragma once

#include "engine/distributed/ranks.h"

namespace dda {

// One in a program, in main and before anything else:
//
//   const Processes processes;
//   if (!Processes::is_first()) return Processes::follow();
class Processes {
 public:
  // In the first, the engine then has the solver "petsc".
  Processes();
  // The first lets the others go.
  ~Processes();
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  [[nodiscard]] static bool is_first() { return Ranks::is_first(); }

  // What all but the first do, who touch no file, until that one ends. Returns the exit code. They leave signals to the
  // first: mpirun passes these on to all, and whoever left at once would not be there for the step that it ends with.
  static int follow();

 private:
  Ranks ranks_;
};

}  // namespace dda
