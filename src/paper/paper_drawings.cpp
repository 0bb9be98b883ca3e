#include "paper/paper_drawings.h"

#include "paper/bristle_sketch.h"
#include "paper/drive_diagram.h"
#include "paper/joint_diagram.h"
#include "paper/lugre_diagram.h"

namespace tribolog::paper {

std::vector<ReportFigure> paper_drawings(double gear_ratio) {
  return {bristle_sketch_figure(), lugre_diagram_figure(), drive_diagram_figure(gear_ratio),
          joint_diagram_figure(), gear_diagram_figure(gear_ratio)};
}

}  // namespace tribolog::paper
