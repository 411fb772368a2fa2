#include "verification/chapters/chapter_figures.h"

namespace verify {

void add_figure(const std::string& name, const std::string& caption, const dda::LinePlot& plot, Section& section,
                Chapter& chapter) {
  if (plot.lines.empty() || plot.times.size() < 2) return;
  const std::string file = name + ".svg";
  chapter.figures.push_back({file, dda::svg_plot(plot)});
  section.pieces.emplace_back(Figure{file, caption});
}

}  // namespace verify
