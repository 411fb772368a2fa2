// Histories, and points over distances, as plots (SVG), for documents.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/view/histories.h"

namespace dda {

struct PlottedLine {
  std::string name;
  std::vector<double> values;  // at the plot's times; what is no number leaves a gap
  bool is_dots = false;        // not joined
};

struct LinePlot {
  std::string title;
  std::string unit;           // SI, of all lines
  std::vector<double> times;  // ascending; or what `across` names
  std::vector<PlottedLine> lines;
  bool logarithmic = false;  // sizes, over powers of ten; zero is not drawn
  std::string across = "time";
  std::string across_unit = "s";  // SI
  bool logarithmic_across = false;
};

// The text of the plot, as wide as the element around it.
std::string svg_plot(const LinePlot& plot);

}  // namespace dda
