#include <fmt/format.h>

#include "calibration/provenance.h"
#include "cli/commands.h"
#include "render/workers/renderer.h"
#include "wording/words.h"

namespace tribolog::cli {

ExitStatus run_version(bool verbose, Console& console) {
  const calibration::Provenance p = calibration::make_provenance({});
  console.say(fmt::format("tribolog {} ({})", p.tool_version, p.git_revision));
  console.say(fmt::format("compiler {}", p.compiler));
  console.say(fmt::format("Eigen {}", p.eigen_version));
  try {
    const render::figure::RendererInfo info =
        verbose ? render::workers::renderer_info() : render::workers::built_renderer();
    console.say(fmt::format("VTK {} through {}", info.vtk_version, info.back_end));
    if (verbose)
      console.say(fmt::format("renderer {}, Mesa {}", info.gl_renderer, info.gl_version));
    console.say(fmt::format("FreeType {}, font {}", info.freetype_version, info.font));
  } catch (const FigureError& error) {
    console.warn(fmt::format("no figures can be drawn here: {}", wording::words(error)));
    return ExitStatus::figure_failed;
  }
  return ExitStatus::done;
}

}  // namespace tribolog::cli
