#pragma once
// What holds for every figure of the paper, drawing or chart.

#include <vector>

#include "figures/report_figure.h"

namespace tribolog::test {

/// Ids are distinct and safe as file names, titles short, texts whole sentences without markup.
void expect_complete_in_words(const std::vector<figures::ReportFigure>& figures);

/// Every picture is drawn without an error or a warning. Where TRIBOLOG_SAVE_DRAWINGS names a
/// folder, the pictures are left there to be looked at.
void expect_drawn_whole(const std::vector<figures::ReportFigure>& figures);

}  // namespace tribolog::test
