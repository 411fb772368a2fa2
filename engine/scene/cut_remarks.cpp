#include "engine/scene/cut_remarks.h"

#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <map>

#include "engine/core/place_in_words.h"
#include "engine/cutting/block_shape.h"
#include "engine/geometry/polygon.h"

namespace dda {
namespace {

void remark_on_slender_blocks(const Rock& rock, const CutRock& cut, std::vector<std::string>& remarks) {
  std::size_t slender = 0;
  double largest = slender_aspect;
  Vec2 place = Vec2::Zero();
  for (const CutBlock& block : cut.blocks) {
    const double aspect = shape_of(block.shape).aspect;
    if (aspect > slender_aspect) ++slender;
    if (!(aspect > largest)) continue;
    largest = aspect;
    place = area_moments(block.shape).centroid;
  }
  if (slender == 0) return;
  remarks.push_back(
      fmt::format("cutting \"{}\": {} of {} blocks are more than {:g} times as long as wide, the one at {} {:.3g} "
                  "times; \"merge\" with an area or an angle takes them to neighbours",
                  rock.group.name, slender, cut.blocks.size(), slender_aspect, place_in_words(place), largest));
}

}  // namespace

std::string cleaned_in_words(const std::vector<const CutRock*>& rocks) {
  std::map<Cleaning, int> counts;
  for (const CutRock* rock : rocks) {
    for (const Cleaned& cleaned : rock->cleaned) ++counts[cleaned.what];
  }
  std::string text;
  for (const auto& [what, count] : counts)
    text += fmt::format("{}{} x {}", text.empty() ? "" : ", ", count, to_string(what));
  return text;
}

std::vector<std::string> cut_remarks(const Rock& rock, const CutRock& cut) {
  std::vector<std::string> remarks;
  for (const auto* own : {&rock.remarks, &cut.remarks}) {
    for (const std::string& remark : *own)
      remarks.push_back(fmt::format("cutting \"{}\": {}", rock.group.name, remark));
  }
  if (const std::string cleaned = cleaned_in_words({&cut}); !cleaned.empty())
    remarks.push_back(fmt::format("cutting \"{}\" cleaned {} (dda cut says where)", rock.group.name, cleaned));
  if (cut.dropped_area > 0)
    remarks.push_back(fmt::format("cutting \"{}\" dropped {:.3g} m2 in slivers without neighbour", rock.group.name,
                                  cut.dropped_area));
  remark_on_slender_blocks(rock, cut, remarks);
  return remarks;
}

}  // namespace dda
