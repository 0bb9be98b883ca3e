#include "render/workers/drawing_worker.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <memory>
#include <optional>

#include <malloc.h>
#include <unistd.h>

#include "error.h"
#include "render/check/picture_check.h"
#include "render/layout/figure_layout.h"
#include "render/paint/painter.h"
#include "render/png/png_encoder.h"
#include "render/text/font.h"
#include "render/text/utf8.h"

namespace tribolog::render {
namespace {

void prepare_driver(bool alone) {
  constexpr int keep_what_the_user_set = 0;
  // Otherwise Mesa writes to the user's home, and some versions print shaders.
  setenv("MESA_SHADER_CACHE_DISABLE", "true", keep_what_the_user_set);
  setenv("LIBGL_ALWAYS_SOFTWARE", "true", keep_what_the_user_set);
  setenv("GALLIUM_DRIVER", "llvmpipe", keep_what_the_user_set);
  if (!alone) setenv("LP_NUM_THREADS", "0", keep_what_the_user_set);
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

void put_info(Message& message, const RendererInfo& info) {
  for (const std::string* text : texts_of(info)) message.put(*text);
}

RendererInfo take_info(Message& message) {
  RendererInfo info;
  for (std::string* text : texts_of(info)) *text = message.take_text();
  return info;
}

std::string printable_text(const std::string& text) { return encode_utf8(decode_utf8(text).text); }

class Worker {
 public:
  DrawnFigure draw(const Figure& figure) {
    DrawnFigure drawn;
    drawn.id = figure.id;
    drawn.width_px = figure.width_px;
    drawn.height_px = figure.height_px;
    obey_test_hooks(figure.id);
    try {
      start();
      drawn.drawn_by = painter_->info();
      const DrawList list = lay_out(figure, *font_);
      drawn.warnings = list.warnings;
      const Picture picture = painter_->paint(list);
      PictureFindings findings = check_picture(list, figure, picture);
      drawn.warnings.insert(drawn.warnings.end(), findings.warnings.begin(),
                            findings.warnings.end());
      if (warn_of_renderer_) {
        drawn.warnings.push_back("drawn by '" + painter_->info().gl_renderer +
                                 "' instead of llvmpipe; pictures may differ between machines");
      }
      drawn.error = std::move(findings.error);
      if (drawn.error.empty()) drawn.png = encode_png(picture);
    } catch (const std::exception& problem) {
      drawn.error = problem.what();
    }
    // They quote titles and labels, and end up on a terminal.
    drawn.error = printable_text(drawn.error);
    for (std::string& warning : drawn.warnings) warning = printable_text(warning);
    return drawn;
  }

 private:
  void start() {
    if (!start_error_.empty()) throw FigureError(start_error_);
    try {
      if (!font_) font_ = std::make_unique<Font>();
      if (!painter_) {
        painter_ = std::make_unique<Painter>(*font_);
        warn_of_renderer_ = painter_->info().gl_renderer.find("llvmpipe") == std::string::npos;
      }
    } catch (const std::exception& problem) {
      start_error_ = problem.what();
      throw;
    }
  }

  std::unique_ptr<Font> font_;
  std::unique_ptr<Painter> painter_;
  bool warn_of_renderer_{false};
  std::string start_error_;
};

}  // namespace

void serve_figures(int socket, const std::vector<Figure>& figures, bool alone,
                   const std::vector<int>& foreign_sockets) {
  for (const int foreign : foreign_sockets) close(foreign);
  prepare_driver(alone);
  keep_freed_memory();
  // Never destroyed: the process ends with _exit, and tearing a graphics stack down takes time.
  auto* worker = new Worker;
  while (auto request = receive_message(socket)) {
    const DrawnFigure drawn = worker->draw(figures.at(request->take_number()));
    Message answer;
    answer.put(drawn.png);
    answer.put(drawn.error);
    answer.put(static_cast<std::uint32_t>(drawn.warnings.size()));
    for (const std::string& warning : drawn.warnings) answer.put(warning);
    put_info(answer, drawn.drawn_by);
    if (!send_message(socket, answer)) return;
  }
}

DrawnFigure read_drawn_figure(Message& message) {
  DrawnFigure drawn;
  drawn.png = message.take_bytes();
  drawn.error = message.take_text();
  const std::uint32_t count = message.take_number();
  for (std::uint32_t i = 0; i < count; ++i) drawn.warnings.push_back(message.take_text());
  drawn.drawn_by = take_info(message);
  return drawn;
}

void serve_info(int socket) {
  prepare_driver(true);
  Message answer;
  try {
    const Font font;
    Painter painter(font);
    const RendererInfo info = painter.info();
    answer.put(std::string());
    put_info(answer, info);
  } catch (const std::exception& problem) {
    answer = Message();
    answer.put(std::string(problem.what()));
  }
  send_message(socket, answer);
}

RendererInfo read_info(Message& message) {
  const std::string problem = message.take_text();
  if (!problem.empty()) throw FigureError(problem);
  return take_info(message);
}

}  // namespace tribolog::render
