// Which steps of Newton's method may lead away from the balance, where stretches lie on beds.
//
// A whole step may lead away and the next one straight to the balance: contacts that are far apart close within the
// step, or sliding ends turn round. Or it leads away for good: little is closed of a bed that all but lets go, so it
// has hardly any stiffness, and a whole step throws its blocks far past it. So a step is taken on trust, and if the one
// after it comes no nearer than where both began, the iteration goes back and takes the first in part: the watchdog of
// Chamberlain, Powell, Lemarechal & Pedersen (1982), with the imbalance for the measure. From then on, and until it
// has come nearer, no step that leads away is taken whole.
//
// Springs have pieces to keep to, and gain nothing: 70,500 passes with it in place of 71,100 in 60 random rocks.
#include "engine/solve/friction_passes.h"

namespace dda {
namespace {

// Measured on docs/examples/shaken_wall.json, passes a step, and on seeds 1 to 140 of `dda-verify rocks`, passes a
// search for the balance (geometric mean) and searches that find none:
//   no step is halved                      5.9   1.49   2,798
//   every step that leads away is halved  13.6   1.68   2,155
//   after one step on trust                6.1   1.61   1,869
constexpr int steps_on_trust = 1;
constexpr int most_halvings = 5;

}  // namespace

void FrictionPasses::take_step(Iterate& at, const JudgedBy& judged_by) {
  if (!live_ones_.some_lie) return take_whole_step(at, judged_by);
  const double before = nearest_.is_trust_lost ? imbalance_ : nearest_.imbalance;
  if (nearest_.is_trust_lost || nearest_.steps_away == 0) left_.leave(live_, step_);
  take_whole_step(at, judged_by);
  if (imbalance_ <= before) return;
  if (!nearest_.is_trust_lost) {
    left_.way += step_;
    if (++nearest_.steps_away <= steps_on_trust) return;
    nearest_.is_trust_lost = true;
    take_all();  // the steps since then may have moved other parts of the blocks
    step_ = left_.step - left_.way;
    go_back(at, judged_by);
  }
  halve_step(at, judged_by, before);
}

void FrictionPasses::go_back(Iterate& at, const JudgedBy& judged_by) {
  left_.put_back_pieces(live_);
  take_whole_step(at, judged_by);
}

void FrictionPasses::halve_step(Iterate& at, const JudgedBy& judged_by, double enough) {
  double share = 1;
  for (int halving = 0; halving < most_halvings && !(imbalance_ <= enough); ++halving) {
    share /= 2;
    step_ = -share * left_.step;  // back by half of the way gone
    go_back(at, judged_by);
  }
}

}  // namespace dda
