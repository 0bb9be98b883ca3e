#pragma once
// Figures to PNG bytes, without a display. The only public door of this folder besides figure.h.

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/statement.h"
#include "render/figure/figure.h"
#include "render/figure/picture.h"

namespace tribolog::render::workers {

/// One drawn figure, or why it could not be drawn.
struct DrawnFigure {
  std::string id;
  std::vector<std::byte> png;  ///< Empty if `error` is not.
  int width_px{};
  int height_px{};
  std::vector<Statement> warnings;  ///< E.g. that samples were dropped that are not finite.
  Statement error;                  ///< Empty if drawn and found whole.
  figure::RendererInfo drawn_by;    ///< Empty texts if the graphics stack could not be started.
};

struct DrawOptions {
  /// Called in the caller's thread after each figure with (done, all).
  std::function<void(std::size_t, std::size_t)> progress;
  std::chrono::milliseconds most_per_figure{60'000};  ///< A worker that takes longer is stopped.
  /// Of scenes the solid parts alone, without lines and texts: what vector_document.h puts below
  /// them.
  bool solid_parts_only{false};
};

/// What the drawing processes prepare for; all of them draw every figure.
enum class Prepared { charts, charts_and_scenes };

/// Draws figures in processes of its own, which end with it.
class FigureRenderer {
 public:
  /// The graphics stack starts at once, in a process beside what the caller does next: make this
  /// before computing what is to be drawn.
  /// @param processes that draw at the same time, at least 1
  /// @param prepared the driver compiles its programs for these once, ahead of the first figure;
  /// for others each process does so at the first one that it draws.
  explicit FigureRenderer(int processes = 2, Prepared prepared = Prepared::charts);
  ~FigureRenderer();
  FigureRenderer(const FigureRenderer&) = delete;
  FigureRenderer& operator=(const FigureRenderer&) = delete;

  /// Draws every figure, in the order given. A figure that cannot be drawn, that comes out blank,
  /// or in which a series is not visible has `error` set; the others are unaffected. A crash of
  /// the graphics stack is confined to the worker and reported the same way, and so is a stack that
  /// does not start.
  std::vector<DrawnFigure> draw(const std::vector<figure::Figure>& figures,
                                const DrawOptions& options = {});

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// What figures are drawn with, as the program was built: VTK, the back end, the font and FreeType.
/// Loads and starts nothing. @throw tribolog::FigureError without the font.
figure::RendererInfo built_renderer();

/// Starts the graphics stack in a worker and asks it what it is.
/// @throw tribolog::FigureError if no off-screen context can be made (one sentence, names the
/// package to install).
figure::RendererInfo renderer_info();

}  // namespace tribolog::render::workers
