#include "engine/distributed/processes.h"

#include <signal.h>

#include <exception>
#include <map>
#include <memory>

#include "engine/distributed/petsc_solver.h"
#include "engine/distributed/row_share.h"
#include "engine/linear/over_processes.h"

namespace dda {
namespace {

using Shares = std::map<int, std::unique_ptr<RowShare>>;

void carry_out(const Order& order, Shares& shares) {
  std::unique_ptr<RowShare>& share = shares[order.solver];
  switch (order.task) {
    case Task::analyze:
      if (!share) share = std::make_unique<RowShare>(order.options);
      return share->analyze(order.blocks, nullptr);
    case Task::factorize: static_cast<void>(share->factorize(nullptr)); return;
    case Task::solve: static_cast<void>(share->solve(order.has_guess, nullptr, nullptr)); return;
    case Task::precondition: return share->precondition(nullptr, nullptr);
    case Task::forget:
    case Task::end: shares.erase(order.solver); return;
  }
}

}  // namespace

Processes::Processes() {
  if (is_first()) share_over_processes({make_petsc_solver, Ranks::count()});
}

Processes::~Processes() {
  if (!is_first()) return;
  share_over_processes({});
  Ranks::give({.task = Task::end});
}

int Processes::follow() {
  for (const int number : {SIGINT, SIGTERM}) signal(number, SIG_IGN);
  try {
    Shares shares;
    for (Order order = Ranks::next_order(); order.task != Task::end; order = Ranks::next_order())
      carry_out(order, shares);
  } catch (const std::exception& error) {
    Ranks::give_up(error.what());
  }
  return 0;
}

}  // namespace dda
