#include "engine/app/unseen_by_fos.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/advice/history_span.h"
#include "engine/model/held_motion.h"

namespace dda {
namespace {

class Unseen {
 public:
  Unseen(const Model& model, double time) : model_(model), time_(time) {}

  template <typename Load>
  void add_load(const Load& load, bool is_there) {
    if (is_there && changing(load.history).to > time_) add("a load on", load.block);
  }

  // A velocity and an acceleration go on for as long as they are not zero.
  template <typename Motion>
  void add_motion(const Motion& motion, bool is_there) {
    if (is_there && (motion.kind != MotionKind::displacement || changing(motion.history).to > time_))
      add("the motion of", motion.block);
  }

  std::vector<std::string> take() { return std::move(names_); }

 private:
  void add(std::string_view what, int block) {
    const std::string name = fmt::format("{} \"{}\"", what, model_.blocks[static_cast<std::size_t>(block)].name);
    if (std::ranges::find(names_, name) == names_.end()) names_.push_back(name);
  }

  const Model& model_;
  double time_;
  std::vector<std::string> names_;
};

}  // namespace

std::vector<std::string> unseen_by_fos(const Model& model, double time) {
  Unseen unseen(model, time);
  for (const EdgeLoad& load : model.edge_loads) unseen.add_load(load, !load.traction.isZero(0));
  for (const PointLoad& load : model.point_loads) unseen.add_load(load, !load.force.isZero(0));
  for (const PointSupport& support : model.supports) unseen.add_motion(support, !support.amplitude.isZero(0));
  for (const HeldBlock& held : model.held_blocks) unseen.add_motion(held, moves(held));
  return unseen.take();
}

std::string said_of_unseen(const std::vector<std::string>& unseen, double time) {
  if (unseen.empty()) return "";
  const std::string more = unseen.size() > 1 ? fmt::format(" and {} more", unseen.size() - 1) : "";
  return fmt::format(
      "not in it: what {}{} changes after {:.6g} s; the factor is that of rest under the loads of that moment\n"
      "  (a steady acceleration k g of the ground, as of a seismic coefficient k, is a \"gravity\" of [-k g, -g])\n",
      unseen.front(), more, time);
}

}  // namespace dda
