#pragma once
// Friction models side by side: one small chart for each model and experiment.

#include <string>
#include <vector>

#include "figures/report_figure.h"
#include "friction/catalogue.h"

namespace tribolog::figures::experiments {

/// The charts of one experiment, one a model; all with the same axes, and LuGre's curve
/// over each in dashes.
struct ModelExperiment {
  std::string id;           ///< "static-curve"
  std::string title;        ///< "Static curve"
  std::string explanation;  ///< What is done, and what to look for.
  std::vector<ReportFigure> figures;
};

/// Static curve, pre-sliding loop, frictional lag and break-away of every model, with parameters
/// that match the contact.
std::vector<ModelExperiment> model_experiments(const friction::ContactParameters& contact);

}  // namespace tribolog::figures::experiments
