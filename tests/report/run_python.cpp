#include "report/run_python.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include <unistd.h>

namespace tribolog::test {

bool has_python_module(const std::string& module) {
  return std::system(("python3 -c 'import " + module + "' 2>/dev/null").c_str()) == 0;
}

std::optional<std::string> run_python(const std::string& program, const std::string& input) {
  const auto directory =
      std::filesystem::temp_directory_path() / ("tribolog-report-test-" + std::to_string(getpid()));
  std::filesystem::create_directories(directory);
  const auto script = directory / "program.py";
  const auto data = directory / "input";
  std::ofstream(script) << program;
  std::ofstream(data, std::ios::binary) << input;

  std::string printed;
  const std::string command = "python3 '" + script.string() + "' '" + data.string() + "' 2>&1";
  std::FILE* const pipe = popen(command.c_str(), "r");
  std::array<char, 4096> part{};
  for (std::size_t got = 0;
       pipe != nullptr && (got = fread(part.data(), 1, part.size(), pipe)) > 0;) {
    printed.append(part.data(), got);
  }
  const bool succeeded = pipe != nullptr && pclose(pipe) == 0;
  std::filesystem::remove_all(directory);
  if (!succeeded) std::fputs(printed.c_str(), stderr);
  return succeeded ? std::optional(printed) : std::nullopt;
}

}  // namespace tribolog::test
