#pragma once
// The figures of a calibration, as pictures or vector graphics, drawn without a display.

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

/// Where the figures are to be used.
enum class FigureStyle {
  report,  ///< As in the report, 160 mm wide.
  paper,   ///< For the columns of a journal: 84 or 174 mm, with the title left to the caption.
};

/// Whether these formats need a renderer: pictures (PNG) do, and so do the drawings of a robot,
/// whose solid parts are a picture in every format; charts as SVG or PDF do not.
/// @param manifest of the dataset. @throw Failure input_refused: it cannot be used.
TRIBOLOG_EXPORT bool needs_renderer(const std::string& manifest,
                                    const std::vector<FigureFormat>& formats);

struct RendererOptions {
  int processes{2};      ///< Drawing at the same time, at least 1.
  std::string manifest;  ///< Of the dataset; if it names a robot, prepares for its drawings too.
};

/// Draws in separate processes, which end with it: a crash of the graphics stack costs a figure but
/// never the program.
///
/// The processes are forked from the caller's. Create the renderer as early as possible, while the
/// program has no other threads: locks held by other threads would stay locked in the processes,
/// and open files and sockets stay open in them. The processes end with the thread that created the
/// renderer, so that thread must outlive it. One thread at a time may draw with a renderer; several
/// renderers may draw at once.
class TRIBOLOG_EXPORT Renderer {
 public:
  /// Returns at once: the graphics stack starts in the background.
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

/// The outcome of one figure.
struct FigureOutcome {
  std::string id;  ///< "fig-15-hysteresis"
  std::vector<std::string> warnings;
  std::string error;  ///< Why it is missing; empty: it was drawn and passed its checks.
};

struct FigureOptions {
  std::vector<FigureFormat> formats{FigureFormat::png};
  FigureStyle style{FigureStyle::report};
  std::string language{"en"};
  Progress progress;
};

struct Figures {
  std::vector<File> files;              ///< "fig-15-hysteresis.svg"
  std::vector<FigureOutcome> outcomes;  ///< One per figure, in the report's order.
  [[nodiscard]] TRIBOLOG_EXPORT std::size_t drawn()
      const;  ///< How many were drawn in every format.
};

/// Draws every figure for which there are numbers. One that cannot be drawn does not affect the
/// others.
/// @param renderer may be null if needs_renderer() returns false.
/// @throw Failure usage: no such language, a calibration without its recordings, or no renderer
///        although one is needed.
TRIBOLOG_EXPORT Figures draw_figures(const Calibration& calibration,
                                     const FigureOptions& options = {},
                                     Renderer* renderer = nullptr);

}  // namespace tribolog
