#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "render/check/picture_check.h"
#include "render/composition/figure_layout.h"
#include "render/example_figures.h"
#include "render/paint/painter.h"
#include "render/png_reading.h"
#include "render/workers/drawing_worker.h"
#include "render/workers/renderer.h"
#include "wording/words.h"

namespace tribolog::render::scene_picture_test {
namespace {

workers::DrawnFigure drawn(const figure::Figure& figure) {
  return workers::FigureRenderer(1).draw({figure}).at(0);
}

TEST(ScenePicture, IsWholeInBothProjections) {
  for (const double opening : {0.0, 30.0}) {
    const workers::DrawnFigure result = drawn(examples::scene(opening));
    EXPECT_EQ(wording::words(result.error), "");
    EXPECT_TRUE(result.warnings.empty()) << wording::words(result.warnings[0]);
    EXPECT_FALSE(result.png.empty());
  }
}

TEST(ScenePicture, ShowsPartsWhereTheyBelong) {
  const figure::Figure figure = examples::scene();
  const figure::DrawList list = composition::lay_out(figure, text::Font());
  const figure::Picture picture = read_png(drawn(figure).png);
  const figure::SceneView& view = list.scene->view;
  const auto colour_at = [&](figure::Point3 p, double dy) {
    const figure::PixelPoint at = view.pixel(p);
    return picture.at(static_cast<int>(at.x), static_cast<int>(at.y + dy));
  };
  const figure::Colour orange = colour_at({0.55, 0, 1.18}, 0);
  EXPECT_GT(orange.red, orange.green);
  EXPECT_GT(orange.green, orange.blue + 60);
  const figure::Colour ball = colour_at({0.4, 0, 1.13}, 12);
  EXPECT_GT(ball.red, ball.green + 30) << "shown though it lies inside of the link";
  EXPECT_GT(ball.blue, ball.green + 10);
  EXPECT_EQ(picture.at(5, 500), (figure::Colour{255, 255, 255}));
}

// A chart has no depth buffer and a scene has one: neither may leave a trace in the other.
TEST(ScenePicture, AndChartsDoNotChangeEachOther) {
  const figure::Figure chart = examples::hysteresis();
  const figure::Figure scene = examples::scene();
  figure::Figure narrow = scene;
  narrow.width_px = 900;
  const auto mixed = workers::FigureRenderer(1).draw(
      {scene, chart, scene, examples::scene(30), chart, narrow, scene});
  EXPECT_EQ(wording::words(mixed[0].error), "");
  EXPECT_EQ(mixed[2].png, mixed[0].png);
  EXPECT_EQ(mixed[4].png, mixed[1].png);
  EXPECT_EQ(mixed[6].png, mixed[0].png);
  EXPECT_EQ(drawn(narrow).png, mixed[5].png);
  EXPECT_EQ(drawn(chart).png, mixed[1].png);
  EXPECT_EQ(drawn(scene).png, mixed[0].png);
  EXPECT_EQ(drawn(examples::scene(30)).png, mixed[3].png);
}

TEST(ScenePicture, IsTheSameHoweverTheProcessesWerePrepared) {
  const figure::Figure scene = examples::scene(30);
  for (const figure::Figure& figure : {scene, examples::hysteresis()}) {
    const auto prepared =
        workers::FigureRenderer(1, workers::Prepared::charts_and_scenes).draw({figure}).at(0);
    EXPECT_EQ(wording::words(prepared.error), "");
    EXPECT_EQ(prepared.png, drawn(figure).png);
  }
}

// In a process of its own, as every use of the graphics stack.
TEST(ScenePicture, DoesNotDependOnItsStrips) {
  const auto compare = [] {
    for (const char* variable : {"MESA_SHADER_CACHE_DISABLE", "LIBGL_ALWAYS_SOFTWARE"}) {
      setenv(variable, "true", 1);
    }
    setenv("LP_NUM_THREADS", "0", 1);
    const text::Font font;
    const auto painter = paint::make_painter(font);
    for (const double opening : {0.0, 30.0}) {
      const figure::DrawList list = composition::lay_out(examples::scene(opening), font);
      const figure::Picture usual = painter->paint(list);
      for (const int rows : {100, 1000}) {
        const figure::Picture other = painter->paint(list, rows);
        // Sub-pixel positions are rounded: an edge may move by a sample of the four of a pixel.
        std::size_t changed = 0;
        for (std::size_t i = 0; i < usual.rgb.size(); ++i) {
          changed += std::abs(usual.rgb[i] - other.rgb[i]) > 8 ? 1U : 0U;
        }
        if (changed > usual.rgb.size() / 10'000) {
          std::fprintf(stderr, "%zu of %zu bytes differ\n", changed, usual.rgb.size());
          std::_Exit(1);
        }
      }
    }
    std::_Exit(0);
  };
  EXPECT_EXIT(compare(), testing::ExitedWithCode(0), "");
}

/// Threads of a process of its own that has prepared and drawn this; 0: it could not.
int threads_after(workers::Prepared prepared, const figure::Figure& figure) {
  const pid_t child = fork();
  if (child == 0) {
    workers::DrawingWorker worker;
    worker.warm_up(prepared);
    const bool drawn = worker.draw(figure).error.empty();
    const std::filesystem::directory_iterator threads("/proc/self/task");
    std::_Exit(drawn ? static_cast<int>(std::distance(begin(threads), end(threads))) : 0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 0;
}

// Only a process with one thread can be forked once it is prepared.
TEST(ScenePicture, LeavesItsProcessWithOneThread) {
  const int of_charts = threads_after(workers::Prepared::charts, examples::plain());
  ASSERT_GT(of_charts, 0);
  if (of_charts > 1) GTEST_SKIP() << workers::renderer_info().back_end << " has threads of its own";
  EXPECT_EQ(threads_after(workers::Prepared::charts_and_scenes, examples::scene(30)), 1);
}

TEST(ScenePicture, IsWarnedAboutWhereALabelledPartIsHidden) {
  figure::Figure figure = examples::scene();
  figure.scene->balls[0].inside = false;
  const workers::DrawnFigure hidden = drawn(figure);
  EXPECT_EQ(wording::words(hidden.error), "");
  EXPECT_EQ(
      wording::words(hidden.warnings),
      (std::vector<std::string>{"the part 'm_{3}' is hidden by others, or outside the picture"}));
}

TEST(PictureCheck, FindsAPartOrALineThatIsMissing) {
  const figure::Figure figure = examples::scene();
  const figure::DrawList list = composition::lay_out(figure, text::Font());
  const figure::Picture whole = read_png(drawn(figure).png);
  EXPECT_EQ(wording::words(check::check_picture(list, figure, whole).error), "");

  figure::Picture grey = whole;  // as a driver that loses the colours
  for (std::size_t i = 0; i < grey.rgb.size(); i += 3) {
    grey.rgb[i] = grey.rgb[i + 2] = grey.rgb[i + 1];
  }
  EXPECT_FALSE(check::check_picture(list, figure, grey).error.empty());

  figure::Picture flat = whole;  // as a driver that draws texts and lines only
  for (std::size_t i = 0; i < flat.rgb.size(); ++i) {
    if (std::max({whole.rgb[i - i % 3], whole.rgb[i - i % 3 + 1], whole.rgb[i - i % 3 + 2]}) >
        120) {
      flat.rgb[i] = 255;
    }
  }
  EXPECT_FALSE(check::check_picture(list, figure, flat).error.empty());
}

}  // namespace
}  // namespace tribolog::render::scene_picture_test
