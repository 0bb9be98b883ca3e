#include <fmt/format.h>

#include "provenance.h"

#include "cli/commands.h"
#include "render/renderer.h"

namespace tribolog {

ExitStatus run_version(Console& console) {
  const Provenance p = make_provenance({});
  console.say(fmt::format("tribolog {} ({})", p.tool_version, p.git_revision));
  console.say(fmt::format("compiler {}", p.compiler));
  console.say(fmt::format("Eigen {}", p.eigen_version));
  try {
    const render::RendererInfo info = render::renderer_info();
    console.say(fmt::format("VTK {}", info.vtk_version));
    console.say(fmt::format("Mesa {}", info.gl_version));
    console.say(fmt::format("renderer {} through {}", info.gl_renderer, info.back_end));
    console.say(fmt::format("FreeType {}, font {}", info.freetype_version, info.font));
  } catch (const FigureError& error) {
    console.warn(fmt::format("no figures can be drawn here: {}", error.what()));
    return ExitStatus::figure_failed;
  }
  return ExitStatus::done;
}

}  // namespace tribolog
