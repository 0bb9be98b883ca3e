#include "cli/input_cases/case_log.h"

#include <cmath>
#include <cstddef>

#include <fmt/ranges.h>

#include "cli/small_dataset.h"

namespace tribolog::test {

std::string case_log(const Change& change, const std::string& header, const std::string& delimiter,
                     int rows) {
  std::string log = header + "\n";
  for (int i = 0; i < rows; ++i) {
    const bool up = i < 400;
    const double t = 0.05 * i;
    const double q = up ? -0.8 + 0.1 * t : 1.2 - 0.1 * (t - 20);
    const double tau = 3.0 * std::cos(q - 0.2) + (up ? 0.5 : -0.5);
    Row fields{fmt::format("{:.2f}", t), fmt::format("{:.9f}", q), fmt::format("{:.9f}", tau)};
    if (change) change(i, fields);
    log += fmt::format("{}\n", fmt::join(fields, delimiter));
  }
  return log;
}

std::string with_line_301(const std::string& line) {
  std::string log = case_log();
  std::size_t start = 0;
  for (int i = 1; i < 301; ++i) start = log.find('\n', start) + 1;
  return log.replace(start, log.find('\n', start) - start, line);
}

std::string case_manifest() { return small_manifest(); }

std::string case_manifest(const std::string& from, const std::string& to) {
  return replaced(small_manifest(), from, to);
}

std::string scaled(const std::string& number, double factor, double offset, int decimals) {
  return fmt::format("{:.{}f}", std::stod(number) * factor + offset, decimals);
}

}  // namespace tribolog::test
