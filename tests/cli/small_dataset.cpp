#include "cli/small_dataset.h"

#include <cmath>
#include <cstddef>
#include <sstream>
#include <stdexcept>

namespace tribolog::test {

std::string small_log() {
  std::ostringstream log;
  log.precision(12);
  log << "t,q,tau\n";
  for (int i = 0; i <= 4000; ++i) {
    const double t = 0.01 * i;
    const bool up = t < 20;
    const double q = up ? -0.8 + 0.1 * t : 1.2 - 0.1 * (t - 20);
    log << t << ',' << q << ',' << 3.0 * std::cos(q - 0.2) + (up ? 0.5 : -0.5) << '\n';
  }
  return log.str();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("nothing to replace: " + from);
  return text.replace(at, from.size(), to);
}

SmallDataset::SmallDataset(const std::string& manifest, const std::string& log) {
  scratch_.write("dataset.toml", manifest);
  scratch_.write("log.csv", log);
}

ProgramRun SmallDataset::run(const std::string& command, const std::string& output) const {
  return run_shell(program + command + " '" + file("dataset.toml") + "' -o '" + file(output) + "'");
}

}  // namespace tribolog::test
