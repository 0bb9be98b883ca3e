#include <filesystem>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/atomic_file.h"
#include "calibration/provenance.h"
#include "cli/archive_commands.h"
#include "cli/shared_options.h"
#include "history/history_json.h"
#include "report/fleet_page.h"
#include "wording/number_text.h"

namespace tribolog::cli {
namespace {

struct FleetOptions {
  archive::store::Filter filter;
  std::string output;
  std::string reports;
  bool json{false};
  wording::Language language;
};

void check(const FleetOptions& options) {
  if (options.output.empty() && !options.json) {
    throw UsageError("archive fleet: -o PAGE or --json is needed");
  }
  if (!options.reports.empty() && options.output.empty()) {
    throw UsageError("archive fleet: --reports needs -o PAGE, which links to them");
  }
}

/// The way from the page to the reports.
std::string directory_from(const std::string& page, const std::string& reports) {
  namespace fs = std::filesystem;
  const fs::path from = fs::absolute(page).parent_path().lexically_normal();
  return fs::absolute(reports).lexically_normal().lexically_relative(from).generic_string();
}

/// A server, or a file without its directories, which would tell about the machine.
std::string shown_name(const std::string& archive) {
  return archive::store::is_server(archive) ? archive
                                            : std::filesystem::path(archive).filename().string();
}

/// The report of each joint's latest calibration, if the archive has it.
report::FleetLinks add_reports(const history::Fleet& fleet, const FleetOptions& options,
                               archive::store::CalibrationArchive& kept, AtomicFiles& files,
                               Console& console) {
  report::FleetLinks links{{}, directory_from(options.output, options.reports)};
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
  return links;
}

/// The reports that an earlier call left beside the page or in its folder "reports", under the
/// whole id or the digits that the page shows.
report::FleetLinks found_reports(const history::Fleet& fleet, const std::string& page) {
  namespace fs = std::filesystem;
  const fs::path beside = fs::absolute(page).parent_path();
  report::FleetLinks links;
  for (const history::FleetRobot& robot : fleet.robots) {
    for (const history::FleetJoint& joint : robot.joints) {
      const std::string& id = joint.latest.id;
      for (const std::string& name : {id, id.substr(0, calibration::shown_digits)}) {
        for (const char* const folder : {"", "reports/"}) {
          const std::string file = folder + name + ".html";
          std::error_code ignored;
          if (fs::is_regular_file(beside / file, ignored)) links.found.emplace(id, file);
        }
      }
    }
  }
  return links;
}

}  // namespace

Run add_fleet(CLI::App& archive) {
  const auto options = std::make_shared<FleetOptions>();
  CLI::App& command =
      *archive.add_subcommand("fleet", "all robots and joints on one page, outliers first");
  command.add_option("-o,--output", options->output, "page (HTML) to write");
  command.add_option("--reports", options->reports,
                     "directory for the report of each joint's latest calibration; the page links "
                     "to them");
  add_filter(command, options->filter);
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
    const history::Fleet fleet = history::fleet_of(kept.measured(filter), kept.decisions(filter));
    if (options->json) print_json(history::fleet_json(fleet));
    if (options->output.empty()) return ExitStatus::done;
    report::FleetLinks links = found_reports(fleet, options->output);
    AtomicFiles files;
    if (!options->reports.empty()) links = add_reports(fleet, *options, kept, files, call.console);
    files.add(options->output,
              report::fleet_page(fleet, links, shown_name(kept.name()),
                                 calibration::make_provenance(call.arguments), options->language));
    files.commit();
    if (!options->json) {
      call.console.say(fmt::format(
          "fleet sheet: {} ({}, {})", printable(options->output, longest_path),
          wording::counted(fleet.robots.size(), "robot"), wording::counted(fleet.joints, "joint")));
    }
    return ExitStatus::done;
  };
}

}  // namespace tribolog::cli
