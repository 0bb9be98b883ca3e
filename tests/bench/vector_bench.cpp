// The paper's figures in each format: how many bytes, and how long it takes. With a directory as
// argument the files are kept there; with "paper" behind it, in the look of a publication.

#include <chrono>
#include <cstdio>
#include <string>

#include "base/atomic_file.h"
#include "ingest/manifest/robot_file.h"
#include "ingest/manifest/scenario_file.h"
#include "paper/checks/paper_items.h"
#include "render/composition/figure_layout.h"
#include "render/composition/publication.h"
#include "render/vector/vector_document.h"
#include "render/workers/renderer.h"
#include "wording/words.h"

namespace {

using namespace tribolog;
using Clock = std::chrono::steady_clock;

struct Written {
  std::size_t bytes{};
  double seconds{};
};

template <class Document>
Written write_all(const std::vector<tribolog::figures::ReportFigure>& figures,
                  const std::string& directory, const std::string& ending, Document&& document) {
  Written sum;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const auto start = Clock::now();
    const std::string bytes = document(i);
    sum.seconds += std::chrono::duration<double>(Clock::now() - start).count();
    sum.bytes += bytes.size();
    std::printf("  %-32s %s %8zu bytes\n", figures[i].id.c_str(), ending.c_str(), bytes.size());
    if (!directory.empty()) {
      tribolog::write_file_atomically(directory + "/" + figures[i].id + "." + ending, bytes);
    }
  }
  return sum;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string directory = argc > 1 ? argv[1] : "";
  const bool publication = argc > 2 && std::string(argv[2]) == "paper";
  const std::string examples = std::string(TRIBOLOG_SOURCE_DIR) + "/examples/paper/";
  if (!directory.empty()) tribolog::create_directory(directory);
  tribolog::render::workers::FigureRenderer renderer(
      2, tribolog::render::workers::Prepared::charts_and_scenes);
  const tribolog::paper::checks::PapersJoint joint(
      tribolog::ingest::manifest::read_scenario(examples + "scenario.toml"),
      tribolog::ingest::manifest::read_robot(examples + "am100ib.toml"));
  std::vector<tribolog::figures::ReportFigure> figures =
      tribolog::paper::checks::paper_figures(joint);
  const tribolog::render::text::Font font;
  std::vector<tribolog::render::figure::Figure> descriptions;
  std::vector<tribolog::render::figure::DrawList> lists;
  for (tribolog::figures::ReportFigure& one : figures) {
    if (publication) one.figure = tribolog::render::composition::for_publication(one.figure, font);
    descriptions.push_back(one.figure);
    lists.push_back(tribolog::render::composition::lay_out(one.figure, font));
  }
  auto start = Clock::now();
  const auto pictures = renderer.draw(descriptions);
  const double picture_s = std::chrono::duration<double>(Clock::now() - start).count();
  tribolog::render::workers::DrawOptions solid_only;
  solid_only.solid_parts_only = true;
  std::vector<std::vector<std::byte>> solid(figures.size());
  start = Clock::now();
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (lists[i].scene) solid[i] = renderer.draw({descriptions[i]}, solid_only).at(0).png;
  }
  const double solid_s = std::chrono::duration<double>(Clock::now() - start).count();
  const auto texts = [&](std::size_t i) {
    return tribolog::render::vector::DocumentTexts{figures[i].id, figures[i].title, figures[i].alt};
  };
  for (const tribolog::render::workers::DrawnFigure& one : pictures) {
    if (!one.error.empty()) {
      std::printf("%s: %s\n", one.id.c_str(), tribolog::wording::words(one.error).c_str());
    }
    for (const std::string& warning : tribolog::wording::words(one.warnings)) {
      std::printf("%s: note: %s\n", one.id.c_str(), warning.c_str());
    }
  }
  const Written png = write_all(figures, directory, "png", [&](std::size_t i) {
    return std::string(reinterpret_cast<const char*>(pictures[i].png.data()),
                       pictures[i].png.size());
  });
  const Written svg = write_all(figures, directory, "svg", [&](std::size_t i) {
    return tribolog::render::vector::svg_document(lists[i], texts(i), font, solid[i]);
  });
  const Written pdf = write_all(figures, directory, "pdf", [&](std::size_t i) {
    return tribolog::render::vector::pdf_document(lists[i], texts(i), font, solid[i]);
  });
  std::printf("%zu figures\n", figures.size());
  std::printf("png %zu bytes, %.2f s by two processes\n", png.bytes, picture_s);
  std::printf("svg %zu bytes, %.2f s by one\n", svg.bytes, svg.seconds);
  std::printf("pdf %zu bytes, %.2f s by one\n", pdf.bytes, pdf.seconds);
  std::printf("solid parts of scenes for both: %.2f s\n", solid_s);
  return 0;
}
