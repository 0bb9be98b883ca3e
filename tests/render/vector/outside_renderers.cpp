#include "render/vector/outside_renderers.h"

#include <cstddef>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "render/png_reading.h"
#include "support/run_program.h"

namespace tribolog::render {
namespace {

using test::ProgramRun;
using test::ScratchDirectory;

void require_success(const test::ProgramRun& run, const std::string& what) {
  if (run.status != 0) throw std::runtime_error(what + ": " + run.err.substr(0, 500));
}

figure::Picture picture_in(const std::string& file) {
  const std::string bytes = test::read_text(file);
  const auto* from = reinterpret_cast<const std::byte*>(bytes.data());
  return read_png({from, from + bytes.size()});
}

figure::Picture pdf_by(const std::string& program, const std::string& pdf, int width, int height) {
  const test::ScratchDirectory scratch;
  const std::string file = scratch.write("figure.pdf", pdf);
  require_success(
      test::run_shell(fmt::format("{} -png -singlefile -scale-to-x {} -scale-to-y {} '{}' '{}'",
                                  program, width, height, file, scratch.file("picture"))),
      program);
  return picture_in(scratch.file("picture.png"));
}

}  // namespace

bool has_program(const std::string& name) {
  return test::run_shell("command -v " + name).status == 0;
}

figure::Picture pdf_by_cairo(const std::string& pdf, int width, int height) {
  return pdf_by("pdftocairo", pdf, width, height);
}

figure::Picture pdf_by_splash(const std::string& pdf, int width, int height) {
  return pdf_by("pdftoppm", pdf, width, height);
}

figure::Picture svg_by_librsvg(const std::string& svg, int width, int height) {
  const test::ScratchDirectory scratch;
  const std::string file = scratch.write("figure.svg", svg);
  const std::string picture = scratch.file("picture.png");
  require_success(test::run_shell(fmt::format("rsvg-convert -w {} -h {} -o '{}' '{}'", width,
                                              height, picture, file)),
                  "rsvg-convert");
  return picture_in(picture);
}

figure::Picture svg_by_chromium(const std::string& svg, int width, int height) {
  const test::ScratchDirectory scratch;
  scratch.write("figure.svg", svg);
  const std::string page = scratch.write(
      "page.html",
      fmt::format("<!doctype html><style>*{{margin:0}}img{{display:block;width:{}px;height:{}px}}"
                  "</style><img src=\"figure.svg\">",
                  width, height));
  const std::string picture = scratch.file("picture.png");
  require_success(
      test::run_shell(fmt::format("timeout 120 chromium --headless --no-sandbox --disable-gpu "
                                  "--hide-scrollbars --user-data-dir='{}' --screenshot='{}' "
                                  "--window-size={},{} 'file://{}'",
                                  scratch.file("profile"), picture, width, height, page)),
      "chromium");
  return picture_in(picture);
}

std::string complaints_of_qpdf(const std::string& pdf) {
  const test::ScratchDirectory scratch;
  const test::ProgramRun run =
      test::run_shell("qpdf --check '" + scratch.write("figure.pdf", pdf) + "'");
  return run.status == 0 ? std::string() : run.out + run.err;
}

std::vector<std::string> fonts_by_poppler(const std::string& pdf) {
  const test::ScratchDirectory scratch;
  const test::ProgramRun run =
      test::run_shell("pdffonts '" + scratch.write("figure.pdf", pdf) + "' | tail -n +3");
  require_success(run, "pdffonts");
  std::vector<std::string> out;
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) out.push_back(line);
  return out;
}

std::string text_by_poppler(const std::string& pdf) {
  const test::ScratchDirectory scratch;
  const test::ProgramRun run =
      test::run_shell("pdftotext -raw '" + scratch.write("figure.pdf", pdf) + "' -");
  require_success(run, "pdftotext");
  return run.out;
}

std::vector<std::string> texts_of_svg(const std::string& svg) {
  static const std::string program = R"(
import sys, xml.etree.ElementTree as tree
root = tree.parse(sys.argv[1]).getroot()
space = '{http://www.w3.org/2000/svg}'
assert root.tag == space + 'svg' and root.get('role') == 'img'
found = [root.find(space + 'title'), root.find(space + 'desc')] + list(root.iter(space + 'text'))
assert not list(root.iter(space + 'script'))
sys.stdout.buffer.write('\n'.join(''.join(one.itertext()) for one in found).encode())
)";
  const test::ScratchDirectory scratch;
  const test::ProgramRun run = test::run_shell(fmt::format(
      "python3 '{}' '{}'", scratch.write("texts.py", program), scratch.write("figure.svg", svg)));
  require_success(run, "python3");
  std::vector<std::string> out;
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) out.push_back(line);
  return out;
}

}  // namespace tribolog::render
