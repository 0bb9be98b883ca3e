#include "export/recording_csv.h"

#include <stdexcept>
#include <vector>

#include "export/shortest_number.h"

namespace tribolog {

std::string recording_csv(const Recording& recording) {
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
  add("torque_Nm", recording.torque_Nm, false);
  add("z_rad", recording.z_rad, true);
  add("dz_rad_s", recording.dz_rad_s, true);
  csv += '\n';
  constexpr std::size_t usual_field_bytes = 20;
  csv.reserve(csv.size() + recording.size() * signals.size() * usual_field_bytes);
  for (std::size_t i = 0; i < recording.size(); ++i) {
    for (std::size_t k = 0; k < signals.size(); ++k) {
      if (k > 0) csv += ',';
      append_number(csv, signals[k][i]);
    }
    csv += '\n';
  }
  return csv;
}

}  // namespace tribolog
