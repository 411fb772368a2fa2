#include "engine/record/lining_frame_writer.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace dda {

LiningFrameWriter::LiningFrameWriter(const Model& model, std::filesystem::path index)
    : model_(model), series_(std::move(index)) {
  std::vector<std::int32_t> linings, elements, blocks_a, blocks_b;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < model.linings.size(); ++i) {
    const Lining& lining = model.linings[i];
    for (std::size_t j = 0; j < lining.elements(); ++j) {
      for (const LiningNode* node : {&lining.start_of(j), &lining.end_of(j)})
        lines_.add_point(node->block, node->point, data_);
      lines_.end_line(data_);
      linings.push_back(static_cast<std::int32_t>(i));
      elements.push_back(static_cast<std::int32_t>(j));
      blocks_a.push_back(lining.start_of(j).block);
      blocks_b.push_back(lining.end_of(j).block);
      names.push_back(lining.name);
    }
  }
  data_.cell_data = {{"lining", 1, std::move(linings)},
                     {"element", 1, std::move(elements)},
                     {"lining_name", 1, std::move(names)},
                     {"block_a", 1, std::move(blocks_a)},
                     {"block_b", 1, std::move(blocks_b)}};
}

void LiningFrameWriter::write(const State& state, std::span<const LiningValues> elements) {
  PolyData data = data_;
  data.time = state.time;
  lines_.place(model_, state, data);
  const auto add = [&](const char* name, auto value) {
    data.cell_data.push_back(numbers_of<double>(name, elements, value));
  };
  data.cell_data.push_back(
      numbers_of<std::int32_t>("status", elements, [](const auto& each) { return each.condition; }));
  add("thrust [N]", [](const auto& each) { return each.thrust; });
  add("moment [N m]", [](const auto& each) { return each.moment; });
  add("shear [N]", [](const auto& each) { return each.shear; });
  add("utilisation", [](const auto& each) { return each.utilisation; });
  series_.add(data);
}

}  // namespace dda
