// The ground reaction curve of an opening: how far its wall comes in where a share of what the rock in it exerted is
// left as support (the convergence-confinement method; AFTES 2002, Recommendations on the convergence-confinement
// method, Tunnels et ouvrages souterrains 170).
//
// The scene's own stages up to the one that takes the opening out bring the rock to its stress in situ. From there, and
// for every share from the same moment, one static stage lets what the opening exerted go to that share. So each point
// is what a run with that share alone comes to, to the last bit, and does not depend on which other shares are asked
// for.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/core/status.h"
#include "engine/reaction/opening_wall.h"
#include "engine/simulation/equilibrium.h"

namespace dda {

struct ReactionQuestion {
  std::vector<int> opening;    // blocks, in a run taken out by one stage, others beside them or not, or by none
  std::vector<double> shares;  // from 1 to 0, decreasing
};

struct ReactionPoint {
  double share = 1;
  WallMotion motion;  // since the rock was settled in situ
  Status status = Status::ok;
  std::string reason;                  // why the rock does not come to rest, for people; empty where it does
  std::vector<UnbalancedBlock> loose;  // blocks that nothing holds any more

  [[nodiscard]] bool settles() const { return status == Status::ok; }
};

struct ReactionCurve {
  OpeningWall wall;
  double pressure = 0;  // Pa, the mean normal pressure on the wall in situ: that at a share of 1
  // In the order asked for, up to the first that does not settle.
  std::vector<ReactionPoint> points;
  Status in_situ = Status::ok;  // else there are no points
  std::string message;          // of stages that did not settle in situ
  // Blocks that nothing held in situ already, as slivers that joints cut free may be: they do not end the curve.
  std::vector<UnbalancedBlock> loose_in_situ;
  // Blocks that nothing holds any more as soon as the opening is out, with all of what it exerted still there, as
  // slivers may be that tractions hold no better than rock: they do not end the curve either, and their faces are not
  // counted in the motion of the wall.
  std::vector<UnbalancedBlock> loose_at_full_share;
  std::vector<std::string> left_out;  // names of bolts and linings that come with the opening or later
  std::vector<int> removed_with_it;   // blocks that the same stage takes out, which let go to the same share
};

// `progress` is called with every point. Throws InputError (without a file) as unloading_of does, and where the opening
// has no wall.
[[nodiscard]] ReactionCurve ground_reaction(const Model& model, const ReactionQuestion& question,
                                            const std::function<void(const ReactionPoint&)>& progress = {});

}  // namespace dda
