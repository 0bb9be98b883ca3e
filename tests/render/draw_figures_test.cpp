#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "base/error.h"
#include "render/example_figures.h"
#include "render/workers/renderer.h"
#include "wording/words.h"

namespace tribolog::render::draw_figures_test {
namespace {

using namespace std::chrono_literals;

class Setting {
 public:
  Setting(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
  ~Setting() { unsetenv(name_); }
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;

 private:
  const char* name_;
};

std::vector<figure::Figure> five() {
  return {examples::plain(), examples::hysteresis(), examples::stacked(), examples::many_curves(10),
          examples::noisy_sweep()};
}

std::vector<workers::DrawnFigure> draw(const std::vector<figure::Figure>& figures, int processes) {
  return workers::FigureRenderer(processes).draw(figures);
}

void expect_no_child_left() {
  errno = 0;
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST(DrawFigures, GivesTheSameBytesForAnyNumberOfProcessesAndOrder) {
  const auto figures = five();
  const auto one = draw(figures, 1);
  const auto three = draw(figures, 3);
  const auto backwards = draw({figures.rbegin(), figures.rend()}, 2);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    EXPECT_EQ(wording::words(one[i].error), "");
    EXPECT_EQ(one[i].id, figures[i].id);
    EXPECT_EQ(one[i].png, three[i].png) << one[i].id;
    EXPECT_EQ(one[i].png, backwards[figures.size() - 1 - i].png) << one[i].id;
  }
  expect_no_child_left();
}

TEST(DrawFigures, ReportsProgressInTheCallersThread) {
  std::vector<std::size_t> steps;
  workers::DrawOptions options;
  options.progress = [&](std::size_t done, std::size_t all) {
    EXPECT_EQ(all, 5U);
    steps.push_back(done);
  };
  workers::FigureRenderer().draw(five(), options);
  EXPECT_EQ(steps, (std::vector<std::size_t>{1, 2, 3, 4, 5}));
}

TEST(DrawFigures, DrawsAgainWithTheSameProcesses) {
  workers::FigureRenderer renderer;
  const auto first = renderer.draw(five());
  const auto second = renderer.draw(five());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(wording::words(first[i].error), "");
    EXPECT_EQ(first[i].png, second[i].png);
  }
}

// A driver with threads cannot be forked once it is started: each worker then starts its own.
TEST(DrawFigures, GivesTheSameBytesWithADriverThatHasThreads) {
  const auto usual = draw(five(), 2);
  const Setting setting("LP_NUM_THREADS", "2");
  const auto threaded = draw(five(), 2);
  for (std::size_t i = 0; i < usual.size(); ++i) {
    EXPECT_EQ(wording::words(threaded[i].error), "");
    EXPECT_EQ(threaded[i].png, usual[i].png) << usual[i].id;
  }
  expect_no_child_left();
}

TEST(DrawFigures, SaysSoAtEachFigureWhereTheGraphicsStackIsLostAtItsStart) {
  const Setting setting("TRIBOLOG_TEST_CRASH_FIGURE", "warm-up");
  for (const workers::DrawnFigure& one : draw(five(), 2)) {
    EXPECT_EQ(
        wording::words(one.error).find("the drawing process was lost: it was stopped by signal 11"),
        0U)
        << wording::words(one.error);
  }
  expect_no_child_left();
}

TEST(DrawFigures, GivesUpOnAGraphicsStackThatHangsAtItsStart) {
  const Setting setting("TRIBOLOG_TEST_HANG_FIGURE", "warm-up");
  workers::DrawOptions options;
  options.most_per_figure = 200ms;
  const auto all =
      workers::FigureRenderer().draw({examples::plain(), examples::hysteresis()}, options);
  for (const workers::DrawnFigure& one : all) {
    EXPECT_EQ(one.error, Statement("drawing.start_took_too_long")) << wording::words(one.error);
  }
  expect_no_child_left();
}

TEST(DrawFigures, DrawsNothingOfNothing) { EXPECT_TRUE(draw({}, 2).empty()); }

TEST(DrawFigures, LosesOnlyTheFigureAtWhichAWorkerCrashes) {
  for (const char* way : {"TRIBOLOG_TEST_CRASH_FIGURE", "TRIBOLOG_TEST_EXIT_FIGURE"}) {
    const Setting setting(way, "stacked");
    for (const int processes : {1, 2}) {
      for (const workers::DrawnFigure& one : draw(five(), processes)) {
        if (one.id == "stacked") {
          EXPECT_TRUE(one.error.is("drawing.process_lost")) << wording::words(one.error);
          EXPECT_TRUE(one.png.empty());
        } else {
          EXPECT_EQ(wording::words(one.error), "");
        }
      }
    }
  }
  expect_no_child_left();
}

TEST(DrawFigures, StopsAWorkerThatHangs) {
  const Setting setting("TRIBOLOG_TEST_HANG_FIGURE", "plain");
  workers::DrawOptions options;
  options.most_per_figure = 5000ms;
  const auto all =
      workers::FigureRenderer().draw({examples::plain(), examples::hysteresis()}, options);
  EXPECT_EQ(all[0].error, Statement("drawing.took_too_long"));
  EXPECT_EQ(wording::words(all[1].error), "");
  expect_no_child_left();
}

TEST(DrawFigures, LeavesNoChildWhenProgressThrows) {
  workers::DrawOptions options;
  options.progress = [](std::size_t, std::size_t) { throw std::runtime_error("stop"); };
  EXPECT_THROW(workers::FigureRenderer().draw(five(), options), std::runtime_error);
  expect_no_child_left();
}

TEST(DrawFigures, ReportsAMissingFontPerFigure) {
  const Setting setting("TRIBOLOG_FONT_DIR", "/nonexistent");
  for (const workers::DrawnFigure& one : draw(five(), 2)) {
    EXPECT_NE(wording::words(one.error).find("fonts-dejavu-core"), std::string::npos);
  }
  EXPECT_THROW(workers::renderer_info(), FigureError);
}

// They are quoted on terminals and pages.
TEST(DrawFigures, QuotesLabelsInWarningsWithoutControlCharacters) {
  figure::Figure figure = examples::plain();
  figure::Series& series = figure.panels[0].series[0];
  series.label = "a\x1b[2Jb\xff";
  series.y.assign(series.x.size(), std::nan(""));
  const workers::DrawnFigure result = draw({figure}, 1).at(0);
  const std::vector<std::string> warnings = wording::words(result.warnings);
  EXPECT_EQ(wording::words(result.error), "");
  EXPECT_EQ(std::count(warnings.begin(), warnings.end(),
                       "series 'a?[2Jb?' has no sample that can be drawn"),
            1);
}

TEST(RendererInfo, NamesEverythingThatMakesAPicture) {
  const figure::RendererInfo info = workers::renderer_info();
  EXPECT_NE(info.gl_renderer.find("llvmpipe"), std::string::npos) << info.gl_renderer;
  EXPECT_NE(info.gl_version.find("Mesa"), std::string::npos);
  EXPECT_FALSE(info.vtk_version.empty());
  EXPECT_FALSE(info.freetype_version.empty());
  EXPECT_TRUE(std::filesystem::exists(info.font));
}

// With another OpenGL library ahead of OSMesa every picture would be white. The program under test
// must be started anew for that, so this test runs another test of its own executable.
TEST(RendererInfo, RefusesAForeignOpenGlLibrary) {
  if (workers::renderer_info().back_end != "OSMesa") GTEST_SKIP() << "only OSMesa can be shadowed";
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string command = "ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD=libGL.so.1 '" +
                              self +
                              "' --gtest_filter=RendererInfo.NamesEverythingThatMakesAPicture 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::string said;
  char buffer[512];
  while (fgets(buffer, sizeof buffer, pipe) != nullptr) said += buffer;
  const int status = pclose(pipe);
  if (said.find("cannot be preloaded") != std::string::npos) GTEST_SKIP() << "no libGL here";
  EXPECT_NE(status, 0);
  EXPECT_NE(said.find("drawing.foreign_opengl"), std::string::npos) << said;
}

}  // namespace
}  // namespace tribolog::render::draw_figures_test
