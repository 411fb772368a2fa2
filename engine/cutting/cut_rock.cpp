#include "engine/cutting/cut_rock.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

#include "engine/core/at_once.h"
#include "engine/core/error.h"
#include "engine/cutting/check_plan.h"
#include "engine/cutting/fill_rock.h"
#include "engine/cutting/finish_blocks.h"
#include "engine/cutting/given_blocks.h"
#include "engine/cutting/line_report.h"
#include "engine/cutting/materials.h"
#include "engine/cutting/merging.h"
#include "engine/cutting/weld.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

void append(std::vector<Cleaned>& all, std::vector<Cleaned> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

// Blocks can only become fewer from here on.
void check_count(const std::vector<FacePlace>& places, const RockPlan& plan, const CutOptions& options) {
  const auto blocks =
      std::count_if(places.begin(), places.end(), [](const FacePlace& place) { return place.in_rock(); });
  if (static_cast<std::size_t>(blocks) > options.most_blocks)
    throw InputError("", plan.boundary_origin, fmt::format("around rock cut into {} blocks", blocks),
                     fmt::format("at most {}", options.most_blocks));
}

double left_out_area(const Arrangement& arrangement, const std::vector<FacePlace>& places) {
  double area = 0;
  const Vec2& reference = arrangement.position(0);
  for (int h = 0; h < arrangement.half_edges(); ++h) {
    const FacePlace& place = places[static_cast<std::size_t>(arrangement.face(h))];
    if (!place.in_boundary || !place.left_out) continue;
    area += cross(Vec2(arrangement.position(arrangement.origin(h)) - reference),
                  Vec2(arrangement.position(arrangement.target(h)) - reference)) /
            2;
  }
  return area;
}

double boundary_area(const RockPlan& plan) {
  double area = std::abs(signed_area(plan.boundary));
  for (const Ring& hole : plan.holes) area -= std::abs(signed_area(hole));
  return area;
}

// The corner that a block gets where its outline would touch itself lies aside by as much as is still told apart.
void part_where_touching(Arrangement& arrangement, const FaceGroups& groups, const PlanPieces& pieces,
                         std::vector<Outline>& outlines, std::vector<Cleaned>& cleaned) {
  if (part_touching(arrangement, outlines, pieces.grid, 2 * pieces.tolerance, cleaned))
    outlines = trace_outlines(arrangement, groups);
}

// The blocks are whole, so this is no reason to refuse them; but some may be as thin as round-off.
std::string unfinished_remark(const PlanPieces& pieces) {
  return fmt::format(
      "corners and lines nearer to each other than {:.3g} m may be left, expected none after all rounds of closing "
      "round-off; a larger \"tolerance\" joins them",
      round_off_of(pieces));
}

CutRock cut_filled(const RockPlan& plan, const CutOptions& options) {
  CutOptions without_merging = options;
  without_merging.least_area = without_merging.least_angle = 0;
  const CutRock unfilled = cut_rock(without_fills(plan), without_merging);
  if (options.progress) options.progress("filling blocks with cells");
  FilledPlan filled = with_cells(plan, unfilled.blocks);
  CutRock rock = cut_rock(filled.plan, options);
  rock.fills = std::move(filled.fills);
  append(rock.cleaned, std::move(filled.cleaned));
  return rock;
}

}  // namespace

std::string_view to_string(Cleaning cleaning) {
  switch (cleaning) {
    case Cleaning::line_without_length: return "line without length";
    case Cleaning::line_not_used: return "line not used";
    case Cleaning::dangle_trimmed: return "dangling end trimmed";
    case Cleaning::end_prolonged: return "end prolonged";
    case Cleaning::lines_overlap: return "line along another";
    case Cleaning::sliver_merged: return "sliver merged";
    case Cleaning::sliver_dropped: return "sliver dropped";
    case Cleaning::small_block_merged: return "small block merged";
    case Cleaning::sharp_block_merged: return "sharp block merged";
    case Cleaning::short_edge_closed: return "short edge closed";
    case Cleaning::round_off_closed: return "round-off closed";
    case Cleaning::touching_parted: return "touching outline parted";
    case Cleaning::gap_closed: return "gap closed";
  }
  return "unknown";
}

CutRock cut_rock(const RockPlan& plan, const CutOptions& options) {
  const auto say = [&](std::string_view what) {
    if (options.progress) options.progress(what);
  };
  if (!plan.blocks.empty()) return given_rock(plan, options.tolerance);
  check_plan(plan);
  if (!plan.fills.empty()) return cut_filled(plan, options);
  CutRock rock;
  rock.cleaned = plan.cleaned;
  PlanPieces pieces = pieces_of(plan, options.tolerance);
  rock.tolerance = pieces.tolerance;
  rock.boundary_area = boundary_area(plan);
  append(rock.cleaned, std::move(pieces.cleaned));
  say("finding crossings");
  Noding noding =
      welded(node_pieces(pieces.pieces, pieces.straights, pieces.ends, pieces.grid, steps_of_round_off(pieces)), pieces,
             plan, rock.cleaned, options.most_rounds);
  rock.pieces_noded = noding.pieces_noded;
  rock.pairs_looked_at = noding.pairs_looked_at;
  if (noding.is_unfinished) rock.remarks.push_back(unfinished_remark(pieces));
  say("finding blocks");
  Arrangement arrangement(std::move(noding));
  const std::vector<FacePlace> places = places_of_faces(arrangement, pieces, plan);
  check_openings(arrangement, places, pieces, plan);
  check_count(places, plan, options);
  rock.left_out_area = left_out_area(arrangement, places);
  say("cleaning");
  FaceGroups groups(places);
  const FaceGroups unmerged = groups;
  Merging merging;
  at_once([&] { report_lines(arrangement, unmerged, pieces, plan, rock.cleaned); },
          [&] {
            merging =
                merge_blocks(arrangement, places, {pieces.tolerance, options.least_area, options.least_angle}, groups);
          });
  rock.dangles_trimmed = static_cast<int>(std::ranges::count(rock.cleaned, Cleaning::dangle_trimmed, &Cleaned::what));
  append(rock.cleaned, std::move(merging.cleaned));
  rock.merged = merging.merged;
  rock.outlines_traced = merging.traced;
  rock.dropped_area = merging.dropped_area;
  part_where_touching(arrangement, groups, pieces, merging.outlines, rock.cleaned);
  groups.settle();
  finish_blocks(arrangement, groups, places, merging.outlines, pieces, plan, rock);
  assign_materials(plan, rock);
  return rock;
}

}  // namespace dda
