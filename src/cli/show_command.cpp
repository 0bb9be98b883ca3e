#include <fmt/format.h>

#include "base/input_file.h"
#include "calibration/read_calibration.h"
#include "cli/archive_commands.h"
#include "cli/calibration_text.h"
#include "cli/commands.h"
#include "report/embedded_json.h"

namespace tribolog::cli {
namespace {

constexpr const char* result_element = "tribolog-result";

/// A calibration as it is, or what a page carries.
report::EmbeddedJson numbers_of(const std::string& text, const std::string& file) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && text[first] == '{') return {result_element, text};
  return report::embedded_json(text, file);
}

}  // namespace

ExitStatus run_show(const ShowOptions& options, Console& console) {
  const report::EmbeddedJson numbers = numbers_of(read_file(options.file), options.file);
  if (numbers.element != result_element) {
    if (!options.json) {
      throw UsageError(fmt::format("{}: the page contains {}, which only --json shows",
                                   printable(options.file, longest_path), numbers.element));
    }
    print_json(numbers.json);
    return ExitStatus::done;
  }
  const calibration::NewCalibration made =
      calibration::entry_of_calibration(numbers.json, options.file);
  if (options.json) {
    print_json(numbers.json);
  } else {
    console.say(facts_text(made.facts, "", 1) + "\n" + quantities_text(made.quantities));
  }
  return ExitStatus::done;
}

}  // namespace tribolog::cli
