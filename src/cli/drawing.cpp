#include "cli/drawing.h"

#include <string>

#include <fmt/format.h>

#include "api/drawing.h"
#include "base/atomic_file.h"
#include "inspect/survey/text_table.h"

namespace tribolog::cli {

std::vector<render::workers::DrawnFigure> draw(render::workers::FigureRenderer& renderer,
                                               const std::vector<figures::ReportFigure>& figures,
                                               Console& console) {
  return api::draw(renderer, figures, [&](std::size_t done, std::size_t all) {
    console.progress("drawing figures", done, all);
  });
}

std::size_t tell_failures(const std::vector<render::workers::DrawnFigure>& drawn,
                          Console& console) {
  return tell_failures(api::outcomes_of(drawn), console);
}

std::size_t tell_failures(const std::vector<FigureOutcome>& figures, Console& console) {
  std::size_t failures = 0;
  std::string last;
  for (const FigureOutcome& figure : figures) {
    for (const std::string& warning : figure.warnings) {
      console.warn(fmt::format("{}: note: {}", figure.id, warning));
    }
    if (figure.error.empty()) continue;
    ++failures;
    if (figure.error != last) {
      console.warn(fmt::format("{}: {}", figure.id, figure.error));
    }
    last = figure.error;
  }
  if (failures > 0) {
    console.warn(fmt::format("error: {} of {} figures could not be drawn; the numbers are kept",
                             failures, figures.size()));
  }
  return failures;
}

std::string text_of(const report::elements::Table& table) {
  constexpr std::size_t width = 160;
  inspect::survey::TextTable text(0);
  std::vector<std::string> heading;
  for (const report::elements::Column& column : table.columns) heading.push_back(column.heading);
  text.add(std::move(heading));
  for (const report::elements::Row& row : table.rows) {
    std::vector<std::string> cells;
    for (const std::string& cell : row.cells) cells.push_back(printable(cell));
    text.add(std::move(cells));
  }
  return text.text(width);
}

ExitStatus write_history_page(
    const PageOutput& output, const std::vector<figures::ReportFigure>& figures,
    const Invocation& call,
    const std::function<std::string(const calibration::Provenance&,
                                    const std::vector<render::workers::DrawnFigure>&)>& make_page) {
  calibration::Provenance provenance = calibration::make_provenance(call.arguments);
  std::vector<render::workers::DrawnFigure> drawn;
  if (!figures.empty()) {
    render::workers::FigureRenderer renderer(output.processes);
    drawn = draw(renderer, figures, call.console);
  }
  provenance.drawing = api::software_that_drew(drawn);
  write_file_atomically(output.path, make_page(provenance, drawn));
  call.console.finish();
  call.console.say("page: " + printable(output.path, longest_path));
  return tell_failures(drawn, call.console) > 0 ? ExitStatus::figure_failed : ExitStatus::done;
}

}  // namespace tribolog::cli
