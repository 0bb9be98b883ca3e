#pragma once
// Figures as files of one or more formats.

#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/console.h"
#include "figures/report_figure.h"
#include "render/workers/renderer.h"

namespace tribolog::cli {

struct FigureFile {
  std::string name;  ///< "fig-15-hysteresis.svg"
  std::string bytes;
};

struct FigureFiles {
  std::vector<FigureFile> files;
  std::vector<render::workers::DrawnFigure>
      drawn;            ///< Warnings and errors of each figure; no pictures.
  std::size_t whole{};  ///< Figures that came out in every format.
};

/// "svg" for files and the command line.
const char* ending_of(FigureFormat format);

/// The same figures sized for the columns of a journal. One that cannot be laid out stays as it is:
/// drawing it says why.
/// @throw tribolog::FigureError without the font.
std::vector<figures::ReportFigure> for_publication(std::vector<figures::ReportFigure> figures);

/// Only PNG and the solid parts of scenes need the graphics stack; what does not need it is written
/// without it.
/// @param figures as they are to be read: nothing is translated here
/// @param renderer may be null where it is not needed
FigureFiles figure_files(const std::vector<figures::ReportFigure>& figures,
                         const std::vector<FigureFormat>& formats,
                         render::workers::FigureRenderer* renderer, Console& console);

}  // namespace tribolog::cli
