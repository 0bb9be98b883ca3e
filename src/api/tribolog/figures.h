#pragma once
// A calibration's figures: pictures and vector graphics, without a display.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "tribolog/calibration.h"
#include "tribolog/export.h"
#include "tribolog/files.h"
#include "tribolog/values.h"

namespace tribolog {

enum class FigureFormat { png, svg, pdf };

/// What figures are drawn for.
enum class FigureStyle {
  report,  ///< As in the report, 160 mm wide.
  paper,   ///< For the columns of a journal: 84 or 174 mm, the title left to the caption.
};

/// Whether these need a renderer: pictures (PNG) do, and so do the drawings of a robot, whose solid
/// parts are a picture in every format; charts as SVG or PDF do not.
/// @param manifest of the dataset. @throw Failure input_refused: it cannot be used.
TRIBOLOG_EXPORT bool needs_renderer(const std::string& manifest,
                                    const std::vector<FigureFormat>& formats);

struct RendererOptions {
  int processes{2};      ///< That draw at the same time, at least 1.
  std::string manifest;  ///< Of the dataset: prepares for the robot's drawings too if it names one.
};

/// Draws in processes of its own, which end with it: a crash of the graphics stack costs a figure
/// and never the program.
///
/// These are forked from the caller's. Make it as early as can be, while the program has no other
/// thread: what such a thread holds locked would stay locked in them, and files and sockets that
/// are open stay open in them. They end with the thread that made it, so that thread has to outlive
/// it. One thread at a time may draw with it; several renderers draw at once.
class TRIBOLOG_EXPORT Renderer {
 public:
  /// Returns at once: the graphics stack starts beside what the caller does next.
  /// @throw Failure input_refused: the manifest cannot be used.
  explicit Renderer(const RendererOptions& options = {});
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

 private:
  struct Processes;
  friend struct api::Inside;
  std::unique_ptr<Processes> processes_;
};

/// What became of one figure.
struct FigureOutcome {
  std::string id;  ///< "fig-15-hysteresis"
  std::vector<std::string> warnings;
  std::string error;  ///< Why there is none; empty: it was drawn, and found whole.
};

struct FigureOptions {
  std::vector<FigureFormat> formats{FigureFormat::png};
  FigureStyle style{FigureStyle::report};
  std::string language{"en"};
  Progress progress;
};

struct Figures {
  std::vector<File> files;              ///< "fig-15-hysteresis.svg"
  std::vector<FigureOutcome> outcomes;  ///< Of each figure, in the report's order.
  [[nodiscard]] TRIBOLOG_EXPORT std::size_t drawn() const;  ///< How many came out in every format.
};

/// Draws every figure that there are numbers for. One that cannot be drawn leaves the others.
/// @param renderer may be null where needs_renderer() says so.
/// @throw Failure usage: no such language, a calibration without its recordings, or no renderer
///        where one is needed.
TRIBOLOG_EXPORT Figures draw_figures(const Calibration& calibration,
                                     const FigureOptions& options = {},
                                     Renderer* renderer = nullptr);

}  // namespace tribolog
