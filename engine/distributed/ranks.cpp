#include "engine/distributed/ranks.h"

#include <petscsys.h>
#include <sched.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <thread>

namespace dda {
namespace {

constexpr int tag_of_orders = 1;

// While the first assembles or writes, the others are to leave it the processors; while it passes over contacts, orders
// come some 100 us apart, and to wake up takes as long.
constexpr auto awake = std::chrono::milliseconds(1);
constexpr auto nap = std::chrono::microseconds(100);

void wait_for_order() {
  const auto begin = std::chrono::steady_clock::now();
  for (;;) {
    int is_there = 0;
    MPI_Iprobe(0, tag_of_orders, MPI_COMM_WORLD, &is_there, MPI_STATUS_IGNORE);
    if (is_there != 0) return;
    if (std::chrono::steady_clock::now() - begin < awake) {
      sched_yield();
    } else {
      std::this_thread::sleep_for(nap);
    }
  }
}

// A command line of its own, which keeps PETSc from reading files and from catching signals.
void begin_petsc() {
  unsetenv("PETSC_OPTIONS");
  unsetenv("PETSC_OPTIONS_YAML");
  static std::array<char, 4> name{"dda"};
  static std::array<char, 14> no_files{"-skip_petscrc"};
  static std::array<char, 19> no_signals{"-no_signal_handler"};
  std::array<char*, 4> words{name.data(), no_files.data(), no_signals.data(), nullptr};
  int count = 3;
  char** arguments = words.data();
  if (PetscInitialize(&count, &arguments, nullptr, nullptr) != 0) Ranks::give_up("PETSc does not start");
  static_cast<void>(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
}

}  // namespace

Ranks::Ranks() {
  int granted = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &granted);
  begin_petsc();
}

Ranks::~Ranks() {
  static_cast<void>(PetscFinalize());
  MPI_Finalize();
}

bool Ranks::is_first() { return own() == 0; }

int Ranks::own() {
  int own = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &own);
  return own;
}

int Ranks::count() {
  int count = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  return count;
}

void Ranks::give(const Order& order) {
  for (int other = 1; other < count(); ++other)
    MPI_Send(&order, sizeof order, MPI_BYTE, other, tag_of_orders, MPI_COMM_WORLD);
}

Order Ranks::next_order() {
  wait_for_order();
  Order order;
  MPI_Recv(&order, sizeof order, MPI_BYTE, 0, tag_of_orders, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return order;
}

void Ranks::give_up(const char* reason) {
  std::cerr << "dda: process " << own() << " of " << count() << ": " << reason << std::endl;
  MPI_Abort(MPI_COMM_WORLD, 1);
  std::abort();
}

}  // namespace dda
