#include <filesystem>
#include <map>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "api/drawing.h"
#include "base/atomic_file.h"
#include "base/encodings.h"
#include "calibration/provenance.h"
#include "cli/archive_commands.h"
#include "cli/drawing.h"
#include "cli/robot_joints.h"
#include "cli/shared_options.h"
#include "figures/figure_csv.h"
#include "figures/timeline/trend_figures.h"
#include "history/history_json.h"
#include "history/joint_trend.h"
#include "report/timeline/fleet_page.h"
#include "report/timeline/trend_page.h"
#include "wording/number_text.h"

namespace tribolog::cli {
namespace {

struct FleetOptions {
  archive::store::Filter filter;
  std::string output;
  std::string reports;
  std::string trends;
  bool json{false};
  int processes{2};
  wording::Language language;
};

void check(const FleetOptions& options) {
  if (options.output.empty() && !options.json) {
    throw UsageError("archive fleet: -o PAGE or --json is needed");
  }
  for (const auto& [name, directory] :
       {std::pair{"--reports", options.reports}, {"--trends", options.trends}}) {
    if (directory.empty() || !options.output.empty()) continue;
    throw UsageError(fmt::format("archive fleet: {} needs -o PAGE, which links to them", name));
  }
}

/// The way from the page to another file or directory.
std::string way_from(const std::string& page, const std::string& to) {
  namespace fs = std::filesystem;
  const fs::path from = fs::absolute(page).parent_path().lexically_normal();
  return fs::absolute(to).lexically_normal().lexically_relative(from).generic_string();
}

bool is_file_beside(const std::string& page, const std::string& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(std::filesystem::absolute(page).parent_path() / file,
                                          ignored);
}

/// A server, or a file without its directories, which would tell about the machine.
std::string shown_name(const std::string& archive) {
  return archive::store::is_server(archive) ? archive
                                            : std::filesystem::path(archive).filename().string();
}

/// The report of each joint's latest calibration, if the archive has it.
void add_reports(const history::Fleet& fleet, const FleetOptions& options,
                 archive::store::CalibrationArchive& kept, AtomicFiles& files, Console& console,
                 report::timeline::FleetLinks& links) {
  links.directory = way_from(options.output, options.reports);
  files.make_directory(options.reports);
  std::size_t done = 0;
  for (const history::FleetRobot& robot : fleet.robots) {
    for (const history::FleetJoint& joint : robot.joints) {
      console.progress("writing the reports", done++, fleet.joints);
      const auto html = kept.document(joint.latest, calibration::DocumentKind::report);
      if (!html) continue;
      files.add((std::filesystem::path(options.reports) / (joint.latest.id + ".html")).string(),
                *html);
      links.ids.insert(joint.latest.id);
    }
  }
  console.finish();
}

/// The reports that an earlier call left beside the page or in its folder "reports", under the
/// whole id or the digits that the page shows.
void find_reports(const history::Fleet& fleet, const std::string& page,
                  report::timeline::FleetLinks& links) {
  for (const history::FleetRobot& robot : fleet.robots) {
    for (const history::FleetJoint& joint : robot.joints) {
      const std::string& id = joint.latest.id;
      for (const std::string& name : {id, id.substr(0, calibration::shown_digits)}) {
        for (const char* const folder : {"", "reports/"}) {
          const std::string file = folder + name + ".html";
          if (is_file_beside(page, file)) links.found.emplace(id, file);
        }
      }
    }
  }
}

using RobotName = std::pair<std::string, std::string>;

/// "R1.S1.html"; names that a file cannot have as they are end in digits of their own.
std::string trend_file_of(const RobotName& of) {
  const auto& [robot, serial] = of;
  std::string name = robot.empty() ? "robot" : as_file_name(robot);
  if (!serial.empty()) name += "." + as_file_name(serial);
  if (name != robot + (serial.empty() ? "" : "." + serial)) {
    name += "." + sha256_hex(robot + "\n" + serial).substr(0, calibration::shown_digits);
  }
  return name + ".html";
}

/// A page for each robot with the trends of all its joints.
/// @return whether every figure could be drawn.
bool add_trends(const std::vector<history::JointTrend>& all, const FleetOptions& options,
                AtomicFiles& files, const Invocation& call, report::timeline::FleetLinks& links) {
  std::map<RobotName, std::vector<history::JointTrend>> by_robot;
  for (const history::JointTrend& trend : all) {
    by_robot[{trend.of.robot, trend.of.serial}].push_back(trend);
  }
  files.make_directory(options.trends);
  render::workers::FigureRenderer renderer(options.processes);
  std::size_t failures = 0;
  for (const auto& [of, trends] : by_robot) {
    const auto figures = figures::figures_in(
        options.language, [&] { return figures::timeline::trend_figures(trends); });
    const auto drawn = draw(renderer, figures, call.console);
    calibration::Provenance provenance = calibration::make_provenance(call.arguments);
    provenance.drawing = api::software_that_drew(drawn);
    const std::string file = options.trends + "/" + trend_file_of(of);
    files.add(file,
              report::timeline::trend_page(trends, provenance, figures, drawn, options.language));
    links.trends[of] = way_from(options.output, file);
    failures += tell_failures(drawn, call.console);
  }
  call.console.finish();
  return failures == 0;
}

/// The trends that an earlier call left in the page's folder "trends".
void find_trends(const history::Fleet& fleet, const std::string& page,
                 report::timeline::FleetLinks& links) {
  for (const history::FleetRobot& robot : fleet.robots) {
    const RobotName of{robot.robot, robot.serial};
    const std::string file = "trends/" + trend_file_of(of);
    if (is_file_beside(page, file)) links.trends.emplace(of, file);
  }
}

}  // namespace

Run add_archive_fleet(CLI::App& archive) {
  const auto options = std::make_shared<FleetOptions>();
  CLI::App& command =
      *archive.add_subcommand("fleet", "all robots and joints on one page, outliers first");
  command.add_option("-o,--output", options->output, "page (HTML) to write")->check(page_file());
  command.add_option("--reports", options->reports,
                     "directory for the report of each joint's latest calibration; the page links "
                     "to them");
  command.add_option("--trends", options->trends,
                     "directory for a page with the trends of each robot's joints; the page links "
                     "to them");
  add_filter(command, options->filter);
  add_processes(command, options->processes);
  add_language(command, options->language);
  const auto where = add_archive_options(command);
  command.add_flag("--json", options->json, "as JSON, to standard output");
  command.footer(
      "\nEach joint's latest results against the median of the same joint of the other robots "
      "and\nof its own past, by a robust z; the page explains how. Reports are as large as their "
      "figures:\n--reports writes one for every joint that has one in the archive.");
  return [where, options](const Invocation& call) {
    check(*options);
    where->protect_from(options->output);
    make_way(call.console, options->output, options->json);
    archive::store::CalibrationArchive kept = where->open(archive::sql::Access::read);
    archive::store::Filter filter = options->filter;
    filter.latest_revisions = true;
    const std::vector<calibration::Measured> measured = kept.measured(filter);
    const history::Fleet fleet = history::fleet_of(measured, kept.decisions(filter));
    if (options->json) print_json(history::fleet_json(fleet));
    if (options->output.empty()) return ExitStatus::done;
    const std::vector<history::JointTrend> trends = history::joint_trends(measured, {});
    report::timeline::FleetLinks links;
    AtomicFiles files;
    if (options->reports.empty()) {
      find_reports(fleet, options->output, links);
    } else {
      add_reports(fleet, *options, kept, files, call.console, links);
    }
    bool is_all_drawn = true;
    if (options->trends.empty()) {
      find_trends(fleet, options->output, links);
    } else {
      is_all_drawn = add_trends(trends, *options, files, call, links);
    }
    files.add(options->output,
              report::timeline::fleet_page(fleet, trends, links, shown_name(kept.name()),
                                           calibration::make_provenance(call.arguments),
                                           options->language));
    files.commit();
    if (!options->json) {
      call.console.say(fmt::format(
          "fleet sheet: {} ({}, {})", printable(options->output, longest_path),
          wording::counted(fleet.robots.size(), "robot"), wording::counted(fleet.joints, "joint")));
    }
    return is_all_drawn ? ExitStatus::done : ExitStatus::figure_failed;
  };
}

}  // namespace tribolog::cli
