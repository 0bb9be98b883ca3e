#pragma once
// The terms of a curve model, and their derivatives.

#include <vector>

#include <Eigen/Core>

#include "method/viscous/curve_model.h"
#include "method/viscous/curve_samples.h"

namespace tribolog {

/// Columns of the linear parameters at a sample, in the order of the header's formulas: the law's,
/// then A and B, then L.
/// @param shape logarithms of the shape parameters, speeds in units of `sample.speed_rad_s`.
/// @param derivatives if not null: of the columns by each shape parameter.
void model_columns(const CurveModel& model, const CurveSample& sample, const Eigen::VectorXd& shape,
                   Eigen::RowVectorXd& columns, std::vector<Eigen::RowVectorXd>* derivatives);

}  // namespace tribolog
