#pragma once
// Figure 3: two surfaces in contact through elastic bristles, the picture behind LuGre.

#include "figures/report_figure.h"

namespace tribolog::paper {

ReportFigure bristle_sketch_figure();

}  // namespace tribolog::paper
