// The processes that mpirun has started, and what the first tells the others.
#pragma once

#include "engine/distributed/order.h"

namespace dda {

// MPI and PETSc, from the beginning of main to its end. Options of PETSc are taken from nowhere: neither from the
// command line nor from PETSC_OPTIONS and .petscrc, which would change results without a word in the scene.
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  [[nodiscard]] static bool is_first();
  [[nodiscard]] static int own();  // from 0
  [[nodiscard]] static int count();

  // From the first to all others.
  static void give(const Order& order);
  // Waits for it.
  [[nodiscard]] static Order next_order();

  // Ends all processes: one has failed where others wait for it.
  [[noreturn]] static void give_up(const char* reason);
};

}  // namespace dda
