#include "export/dataset/recording_csv.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "base/shortest_number.h"

namespace tribolog {

namespace {

void append(std::string& text, double value, const LogForm& form) {
  if (form.decimals) {
    fmt::format_to(std::back_inserter(text), "{:.{}f}", value, *form.decimals);
  } else {
    append_number(text, value);
  }
}

std::vector<double> currents_A(const std::vector<double>& torque_Nm, double constant_Nm_A) {
  std::vector<double> currents(torque_Nm.size());
  std::transform(torque_Nm.begin(), torque_Nm.end(), currents.begin(),
                 [&](double torque) { return torque / constant_Nm_A; });
  return currents;
}

}  // namespace

std::string recording_csv(const Recording& recording, const LogForm& form) {
  std::vector<const double*> signals;
  std::string csv;
  const auto add = [&](const char* name, const std::vector<double>& signal, bool is_optional) {
    if (signal.empty() && is_optional) return;
    if (signal.size() != recording.size()) {
      throw std::invalid_argument(std::string(name) + " is not as long as t_s");
    }
    if (!signals.empty()) csv += ',';
    csv += name;
    signals.push_back(signal.data());
  };
  add("t_s", recording.t_s, false);
  add("q_rad", recording.q_rad, false);
  add("dq_rad_s", recording.dq_rad_s, true);
  const bool is_current = form.torque_constant_Nm_A > 0;
  const std::vector<double> currents =
      is_current ? currents_A(recording.torque_Nm, form.torque_constant_Nm_A)
                 : std::vector<double>();
  add(is_current ? "i_A" : "torque_Nm", is_current ? currents : recording.torque_Nm, false);
  add("z_rad", recording.z_rad, true);
  add("dz_rad_s", recording.dz_rad_s, true);
  csv += '\n';
  constexpr std::size_t usual_field_bytes = 20;
  csv.reserve(csv.size() + recording.size() * signals.size() * usual_field_bytes);
  for (std::size_t i = 0; i < recording.size(); ++i) {
    for (std::size_t k = 0; k < signals.size(); ++k) {
      if (k > 0) csv += ',';
      append(csv, signals[k][i], form);
    }
    csv += '\n';
  }
  return csv;
}

}  // namespace tribolog
