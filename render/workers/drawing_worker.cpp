#include "render/workers/drawing_worker.h"

#include <array>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <memory>
#include <utility>
#include <vector>

#include <malloc.h>
#include <unistd.h>

#include "base/error.h"
#include "render/check/picture_check.h"
#include "render/composition/figure_layout.h"
#include "render/paint/painter.h"
#include "render/png/png_encoder.h"
#include "render/text/characters.h"
#include "render/text/font.h"
#include "render/workers/messages.h"

namespace tribolog::render::workers {
namespace {

void prepare_driver() {
  constexpr int keep_what_the_user_set = 0;
  // Otherwise Mesa writes to the user's home, and some versions print shaders.
  setenv("MESA_SHADER_CACHE_DISABLE", "true", keep_what_the_user_set);
  setenv("LIBGL_ALWAYS_SOFTWARE", "true", keep_what_the_user_set);
  setenv("GALLIUM_DRIVER", "llvmpipe", keep_what_the_user_set);
  // Processes instead of threads: they use the cores better, and can be forked.
  setenv("LP_NUM_THREADS", "0", keep_what_the_user_set);
  setenv("mesa_glthread", "false", keep_what_the_user_set);
}

/// Pictures come and go in blocks of megabytes; keeping the pages saves the kernel clearing them.
void keep_freed_memory() {
  constexpr int most = 1 << 30;
  mallopt(M_MMAP_THRESHOLD, most);
  mallopt(M_TRIM_THRESHOLD, most);
}

/// Lets tests see what happens when the graphics stack crashes or hangs at one figure.
void obey_test_hooks(const std::string& id) {
  const auto names_it = [&](const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && id == value;
  };
  if (names_it("TRIBOLOG_TEST_CRASH_FIGURE")) raise(SIGSEGV);
  if (names_it("TRIBOLOG_TEST_EXIT_FIGURE")) _exit(3);
  if (names_it("TRIBOLOG_TEST_HANG_FIGURE")) pause();
}

template <class Info>
auto texts_of(Info& info) {
  return std::array{&info.vtk_version, &info.back_end, &info.gl_version,
                    &info.gl_renderer, &info.font,     &info.freetype_version};
}

void put_info(Message& message, const figure::RendererInfo& info) {
  for (const std::string* text : texts_of(info)) message.put(*text);
}

figure::RendererInfo take_info(Message& message) {
  figure::RendererInfo info;
  for (std::string* text : texts_of(info)) *text = message.take_text();
  return info;
}

std::string printable_text(const std::string& text) {
  return text::encode_utf8(text::decode_utf8(text).text);
}

/// One of each kind of thing that figures are made of.
figure::Figure every_kind() {
  figure::Figure figure;
  figure.id = "warm-up";
  figure.title = "Every kind, T_{f}";
  figure.height_px = 480;  // a single strip
  figure::Panel panel;
  panel.x.title = "q [rad]";
  panel.y.title = "T [N·m]";
  figure::Series line;
  line.label = "line";
  line.x = {0, 1, 2, 3};
  line.y = {0, 1, 0, 1};
  line.style = figure::LineStyle::dash;
  line.direction_arrows_at = {0.5};
  figure::Series markers = line;
  markers.label = "markers";
  markers.style = figure::LineStyle::none;
  markers.marker = figure::Marker::circle;
  panel.bands.push_back({"band", {0, 3}, {0.2, 0.2}, {0.4, 0.4}});
  panel.error_bars.push_back({1.5, 0.2, 0.8});
  panel.point_labels.push_back({1, 1, "A"});
  panel.reference_lines.push_back({figure::ReferenceLine::Direction::vertical, 2.5, "q_{c}"});
  panel.series = {std::move(line), std::move(markers)};
  figure.panels.push_back(std::move(panel));
  return figure;
}

/// The same for scenes: lit and flat surfaces with their outlines, and a line over them.
figure::Figure every_kind_of_part() {
  figure::Figure figure;
  figure.id = "warm-up-scene";
  figure.title = "Every part";
  figure.width_px = 320;
  figure.height_px = 240;
  figure::Scene& scene = figure.scene.emplace();
  scene.ground.emplace();
  figure::SceneBody body;
  body.to = {0, 0, 0.5};
  scene.bodies.push_back(body);
  figure::SceneSector sector;
  sector.normal = {0, -1, 0};
  sector.zero = {1, 0, 0};
  sector.to_rad = 1;
  sector.filled = true;
  sector.label = "q_{c}";
  scene.sectors.push_back(sector);
  return figure;
}

Message drawn_figure_message(const DrawnFigure& drawn) {
  Message message;
  message.put(drawn.png);
  put_statement(message, drawn.error);
  message.put(static_cast<std::uint32_t>(drawn.warnings.size()));
  for (const Statement& warning : drawn.warnings) put_statement(message, warning);
  put_info(message, drawn.drawn_by);
  return message;
}

}  // namespace

struct DrawingWorker::Stack {
  std::unique_ptr<text::Font> font;
  std::unique_ptr<paint::Painter> painter;
  paint::PainterThreads threads{paint::PainterThreads::as_many_as_it_likes};
  Statement start_error;
};

DrawingWorker::DrawingWorker() : stack_(std::make_unique<Stack>()) {
  prepare_driver();
  keep_freed_memory();
}

DrawingWorker::~DrawingWorker() = default;

void DrawingWorker::start() {
  if (!stack_->start_error.empty()) throw FigureError(stack_->start_error);
  try {
    if (!stack_->font) stack_->font = std::make_unique<text::Font>();
    if (!stack_->painter) stack_->painter = paint::make_painter(*stack_->font, stack_->threads);
  } catch (const std::exception& problem) {
    stack_->start_error = stated_by(problem);
    throw;
  }
}

void DrawingWorker::warm_up(Prepared prepared) {
  try {
    // Scenes go through filters that would start threads, and workers are forked after this.
    const bool scenes = prepared == Prepared::charts_and_scenes;
    if (scenes) stack_->threads = paint::PainterThreads::one;
    start();
    std::vector<figure::Figure> figures{every_kind()};
    if (scenes) figures.push_back(every_kind_of_part());
    for (const figure::Figure& figure : figures) {
      obey_test_hooks(figure.id);
      const figure::Picture picture =
          stack_->painter->paint(composition::lay_out(figure, *stack_->font));
      static_cast<void>(png::encode_png(picture));
    }
  } catch (const std::exception&) {
    // The first figure meets the same problem and reports it.
  }
}

DrawnFigure DrawingWorker::draw(const figure::Figure& figure, bool solid_parts_only) {
  DrawnFigure drawn;
  drawn.id = figure.id;
  drawn.width_px = figure.width_px;
  drawn.height_px = figure.height_px;
  obey_test_hooks(figure.id);
  try {
    start();
    paint::Painter& painter = *stack_->painter;
    drawn.drawn_by = painter.info();
    figure::DrawList list = composition::lay_out(figure, *stack_->font);
    if (solid_parts_only) list.primitives.clear();
    drawn.warnings = list.warnings;
    const figure::Picture picture = painter.paint(list);
    check::PictureFindings findings = check::check_picture(list, figure, picture);
    drawn.warnings.insert(drawn.warnings.end(), findings.warnings.begin(), findings.warnings.end());
    if (drawn.drawn_by.gl_renderer.find("llvmpipe") == std::string::npos) {
      drawn.warnings.push_back(
          {"drawing.other_driver", {{"renderer", drawn.drawn_by.gl_renderer}}});
    }
    drawn.error = std::move(findings.error);
    if (drawn.error.empty()) {
      drawn.png = png::encode_png(
          picture, list.scene ? png::SinglePixels::stay : png::SinglePixels::may_be_rounded);
    }
  } catch (const std::exception& problem) {
    drawn.error = stated_by(problem);
  }
  // They quote titles and labels, and end up on a terminal.
  drawn.error = with_texts(drawn.error, printable_text);
  for (Statement& warning : drawn.warnings) warning = with_texts(warning, printable_text);
  return drawn;
}

void DrawingWorker::serve(int socket) {
  while (auto request = receive_message(socket)) {
    const figure::Figure figure = take_figure(*request);
    const DrawnFigure drawn = draw(figure, request->take_number() != 0);
    if (!send_message(socket, drawn_figure_message(drawn))) return;
  }
}

void put_request(Message& message, const figure::Figure& figure, bool solid_parts_only) {
  put_figure(message, figure);
  message.put(std::uint32_t{solid_parts_only ? 1U : 0U});
}

DrawnFigure read_drawn_figure(Message& message) {
  DrawnFigure drawn;
  drawn.png = message.take_bytes();
  drawn.error = take_statement(message);
  const std::uint32_t count = message.take_number();
  for (std::uint32_t i = 0; i < count; ++i) drawn.warnings.push_back(take_statement(message));
  drawn.drawn_by = take_info(message);
  return drawn;
}

void serve_info(int socket) {
  prepare_driver();
  Message answer;
  try {
    const text::Font font;
    const figure::RendererInfo info = paint::make_painter(font)->info();
    put_statement(answer, {});
    put_info(answer, info);
  } catch (const std::exception& problem) {
    answer = Message();
    put_statement(answer, stated_by(problem));
  }
  send_message(socket, answer);
}

figure::RendererInfo read_info(Message& message) {
  const Statement problem = take_statement(message);
  if (!problem.empty()) throw FigureError(problem);
  return take_info(message);
}

}  // namespace tribolog::render::workers
