#include "cli/history_page.h"

#include "api/drawing.h"
#include "base/atomic_file.h"
#include "cli/drawing.h"
#include "inspect/survey/text_table.h"

namespace tribolog::cli {

std::string text_of(const report::Table& table) {
  constexpr std::size_t width = 160;
  inspect::survey::TextTable text(0);
  std::vector<std::string> heading;
  for (const report::Column& column : table.columns) heading.push_back(column.heading);
  text.add(std::move(heading));
  for (const report::Row& row : table.rows) {
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
