#pragma once
// Figure 4: LuGre friction as a block diagram, eq. (3) to (5).

#include "figures/report_figure.h"
#include "friction/lugre.h"
#include "paper/drawings/signal_graph.h"

namespace tribolog::paper::drawings {

/// The model as a graph. Input "speed" [rad/s], integrator "deflection" z [rad] fed by "rate"
/// dz/dt [rad/s], output "friction" T_f [N·m].
SignalGraph lugre_graph(const friction::LuGreFriction& friction);

/// The same graph, drawn; independent of the parameters' values.
figures::ReportFigure lugre_diagram_figure();

}  // namespace tribolog::paper::drawings
