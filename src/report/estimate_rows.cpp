// Rows that tables of estimates are made of.

#include <cmath>

#include "report/view_parts.h"

namespace tribolog::report {

std::string or_dash(const std::string& text) { return text.empty() ? "–" : text; }

std::string as_sentence(const std::string& text) {
  if (text.empty()) return text;
  const std::string first_word = text.substr(0, text.find(' '));
  const bool is_symbol =
      (first_word.size() == 1 && first_word != "a") || first_word.find('_') != std::string::npos;
  std::string sentence = text;
  if (!is_symbol && sentence.front() >= 'a' && sentence.front() <= 'z') {
    sentence.front() = static_cast<char>(sentence.front() - 'a' + 'A');
  }
  const char last = sentence.back();
  return last == '.' || last == '!' || last == '?' || last == ':' ? sentence : sentence + ".";
}

std::vector<Column> estimate_columns() {
  return {{"Quantity", "", false, true},
          {"Estimate", "", true},
          {"Unit", "", false},
          {"95 % interval", "", true},
          {"From", "", false}};
}

Row estimate_row(const std::string& quantity, const Estimate& estimate, const Scale& scale) {
  if (!std::isfinite(estimate.value)) return not_identified_row(quantity, estimate.method);
  const RoundedEstimate text = round_by_interval(estimate, scale);
  return {{quantity, text.plus_minus(), or_dash(scale.unit), or_dash(text.range()),
           or_dash(estimate.method)},
          false};
}

Row number_row(const std::string& quantity, double value, const Scale& scale,
               const std::string& from) {
  if (!std::isfinite(value)) return not_identified_row(quantity, from);
  constexpr int digits = 4;
  return {{quantity, significant(value * scale.factor, digits), or_dash(scale.unit), "–",
           or_dash(from)},
          false};
}

Row not_identified_row(const std::string& quantity, const std::string& why) {
  return {{quantity, "not identified", "–", "–", or_dash(why)}, false};
}

std::string estimator_name(const std::string& estimator) {
  if (estimator.size() == 1) return "Point " + estimator;
  if (estimator.size() == 2) {
    return std::string("Mean of ") + estimator.front() + " and " + estimator.back();
  }
  if (estimator == "midline") return "Mid-line";
  if (estimator == "fit") return "LuGre fit";
  if (estimator == "sweep") return "Sweep";
  if (estimator == "runs") return "Runs at constant speed";
  if (estimator == "stated") return "Stated";
  return estimator;
}

const SurrogateMass* recommended_mass(const Calibration& c) {
  return c.selection.recommended.empty() ? nullptr : c.masses.find(c.selection.recommended);
}

}  // namespace tribolog::report
