#include "paper/drawings/paper_drawings.h"

namespace tribolog::paper::drawings {

std::vector<figures::ReportFigure> paper_drawings(double gear_ratio) {
  return {bristle_sketch_figure(), lugre_diagram_figure(), drive_diagram_figure(gear_ratio),
          joint_diagram_figure(), gear_diagram_figure(gear_ratio)};
}

}  // namespace tribolog::paper::drawings
