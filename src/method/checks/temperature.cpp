// The logged temperature: how far it moved over all recordings.

#include <algorithm>

#include <fmt/format.h>

#include "method/checks/check_list.h"

namespace tribolog {

DataCheck check_temperature(const CheckedDataset& data) {
  // Viscosity of a gear's grease changes by some 3 to 5 % a kelvin.
  constexpr double warning_K = 5;
  constexpr double most_K = 10;
  DataCheck check;
  check.name = "temperature";
  check.title = "Temperature";
  double low = 0, high = 0;
  for (const CheckedRecording& r : data.recordings) {
    for (const double degrees : r.recording->temperature_C) {
      low = check.measured ? std::min(low, degrees) : degrees;
      high = check.measured ? std::max(high, degrees) : degrees;
      check.measured = high - low;
    }
  }
  if (!check.measured) {
    return not_applicable(check.name, check.title, "no temperature is logged");
  }
  check.recording = "all";
  check.measure = "range of the temperature over all recordings";
  check.unit = kelvin;
  check.at_most = warning_K;
  check.found = fmt::format("{:.3g} to {:.3g} °C", low, high);
  check.state = passed_or_warns_up_to(most_K, check);
  if (check.state == CheckState::passed) return check;
  check.consequence =
      "friction changes by some per cent for each kelvin, so recordings of "
      "different temperature do not belong to one curve";
  check.experiment = "warm the joint up first, and record all roles at one temperature";
  return check;
}

}  // namespace tribolog
