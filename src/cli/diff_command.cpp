#include <algorithm>
#include <cmath>

#include <CLI/CLI.hpp>

#include "calibration/friction_speeds.h"
#include "calibration/read_calibration.h"
#include "cli/archive_commands.h"
#include "cli/drawing.h"
#include "cli/shared_options.h"
#include "figures/figure_csv.h"
#include "figures/timeline/comparison_figures.h"
#include "history/history_json.h"
#include "report/timeline/comparison_page.h"
#include "wording/torques_in.h"
#include "wording/tr.h"

namespace tribolog::cli {
namespace {

struct DiffOptions {
  std::vector<std::string> ids;
  std::string output;
  history::AllowedDifference allowed;
  bool different_joints{false};
  bool json{false};
  int processes{2};
  wording::Language language;
};

calibration::RecordedCurves curves_of(archive::store::CalibrationArchive& kept,
                                      const calibration::Entry& entry) {
  const auto json = kept.document(entry, calibration::DocumentKind::calibration);
  return json ? calibration::read_curves(*json) : calibration::RecordedCurves{};
}

/// A torque constant that is wrong changes friction at every speed by the same share as gravity.
void scale_to_friction(std::vector<calibration::Quantity>& quantities) {
  const auto gravity =
      std::find_if(quantities.begin(), quantities.end(), [](const calibration::Quantity& q) {
        return q.name == to_string(joint::Quantity::gravity_torque) && q.estimate &&
               q.estimate->value != 0;
      });
  if (gravity == quantities.end()) return;
  for (calibration::Quantity& q : quantities) {
    if (!calibration::speed_of_friction(q.name) || !q.estimate) continue;
    for (calibration::StatedInfluence influence : gravity->influences) {
      if (influence.name != "torque_constant") continue;
      influence.standard_uncertainty *= std::abs(q.estimate->value / gravity->estimate->value);
      q.influences.push_back(std::move(influence));
    }
  }
}

/// With what the manifests state of their errors.
calibration::Measured measured(archive::store::CalibrationArchive& kept, const std::string& id) {
  const calibration::Entry entry = kept.find(id);
  calibration::Measured made{entry, kept.quantities(entry)};
  const auto json = kept.document(entry, calibration::DocumentKind::calibration);
  if (!json) return made;
  const auto influences = calibration::read_influences(*json);
  for (calibration::Quantity& quantity : made.quantities) {
    const auto of_quantity = influences.find(quantity.name);
    if (of_quantity != influences.end()) quantity.influences = of_quantity->second;
  }
  scale_to_friction(made.quantities);
  return made;
}

/// Which curves cannot be laid over each other, and why.
std::string missing_curves(const calibration::RecordedCurves& a,
                           const calibration::RecordedCurves& b) {
  if (a.torque_unit != b.torque_unit) {
    return wording::tr(
        "The torques of one calibration are in newton metres and those of the other in amperes: "
        "their curves cannot be laid over each other.");
  }
  std::string words;
  if (a.friction.speed_rad_s.empty() || b.friction.speed_rad_s.empty()) {
    words = wording::tr("Not both calibrations hold a friction curve of constant-speed runs.");
  }
  if (a.loops.empty() || b.loops.empty()) {
    if (!words.empty()) words += " ";
    words += wording::tr(
        "Not both hold a hysteresis loop: none was recorded, or the calibration was made by a "
        "version that did not keep it.");
  }
  return words;
}

ExitStatus write_page(const DiffOptions& options, const history::Comparison& comparison,
                      calibration::RecordedCurves first, calibration::RecordedCurves second,
                      const Invocation& call) {
  if (first.torque_unit != second.torque_unit) {
    for (calibration::RecordedCurves* const one : {&first, &second}) {
      one->friction = {};
      one->loops.clear();
    }
  }
  const wording::TorquesIn unit(first.torque_unit);
  const auto figures = figures::figures_in(options.language, [&] {
    return figures::timeline::comparison_figures(comparison, first, second);
  });
  return write_history_page({options.output, options.processes, options.language}, figures, call,
                            [&](const calibration::Provenance& provenance,
                                const std::vector<render::workers::DrawnFigure>& drawn) {
                              const wording::WordsIn words(options.language);
                              return report::timeline::comparison_page(
                                  comparison, first, second, provenance,
                                  missing_curves(first, second), figures, drawn, options.language);
                            });
}

void tell(const history::Comparison& comparison, Console& console) {
  console.say(text_of(report::timeline::compared_conditions_table(comparison)));
  console.say(text_of(report::timeline::compared_quantities_table(comparison)));
  for (const std::string& note : report::timeline::comparison_notes(comparison)) {
    console.say(printable(note, longest_note));
  }
  console.say(report::timeline::comparison_sentence(comparison));
}

}  // namespace

Run add_archive_diff(CLI::App& archive) {
  const auto options = std::make_shared<DiffOptions>();
  CLI::App& command = *archive.add_subcommand("diff", "two calibrations: what changed");
  command.add_option("ID", options->ids, "the first digits of both ids")->required()->expected(2);
  command.add_option("-o,--output", options->output, "page (HTML) to write")->check(page_file());
  command.add_flag("--json", options->json, "as JSON, to standard output");
  command
      .add_option("--allowed-kelvin", options->allowed.temperature_K,
                  "compare friction only up to this temperature difference")
      ->check(number_between(0, 1000))
      ->capture_default_str();
  command.add_flag("--different-joints", options->different_joints,
                   "allow calibrations of different joints");
  add_processes(command, options->processes);
  add_language(command, options->language);
  const auto where = add_archive_options(command);
  command.footer(
      "\nEach quantity's change has a 95 % interval, combined from both. \"changed\" takes "
      "into\naccount that several quantities are compared.");
  return [where, options](const Invocation& call) {
    where->protect_from(options->output);
    make_way(call.console, options->output, options->json);
    archive::store::CalibrationArchive kept = where->open(archive::sql::Access::read);
    std::vector<calibration::Measured> both;
    for (const std::string& id : options->ids) both.push_back(measured(kept, id));
    const history::Comparison comparison =
        history::compare(both[0], both[1], options->allowed, options->different_joints);
    if (options->json) {
      print_json(history::comparison_json(comparison));
    } else {
      tell(comparison, call.console);
    }
    if (options->output.empty()) return ExitStatus::done;
    return write_page(*options, comparison, curves_of(kept, both[0].entry),
                      curves_of(kept, both[1].entry), call);
  };
}

}  // namespace tribolog::cli
