#include "cli/console.h"

#include <iostream>

#include <fmt/format.h>
#include <unistd.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/shown_text.h"
#include "base/standard_output.h"

namespace tribolog::cli {
namespace {

constexpr std::size_t longest_line = 1000;
constexpr std::size_t longest_bar_text = 80;

std::string line_of(const Console::Step& step) {
  if (step.what.empty() || step.name.empty()) return step.what;
  return step.name + ": " + step.what;
}

/// Of several works a line that wraps would be drawn again below: short enough for 80 columns.
std::string bar_of(const Console::Step& step) {
  constexpr std::size_t width = 30;
  constexpr std::size_t longest_of_several = 36;
  const std::size_t longest = step.name.empty() ? longest_bar_text : longest_of_several;
  const std::size_t filled = step.all == 0 ? 0 : width * step.done / step.all;
  return fmt::format(
      "[{}{}] {}/{} {}", std::string(filled, '#'), std::string(width - filled, '.'), step.done,
      step.all, printable(step.what.empty() ? step.name + ": waiting" : line_of(step), longest));
}

/// Of several lines, the cursor being in the last.
std::string back_to_first_line(int lines) {
  return lines > 1 ? fmt::format("\x1b[{}A", lines - 1) : "";
}

}  // namespace

Console::Console(bool quiet)
    : quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()) {}

Console::~Console() { finish(); }

bool Console::is_too_early() const {
  using std::chrono::steady_clock;
  return lines_drawn_ == 0 && steady_clock::now() - start_ < std::chrono::seconds(1);
}

void Console::progress(const std::string& what, std::size_t done, std::size_t all) {
  if (all > 0) progress(std::vector<Step>{{"", what, done, all}});
}

void Console::progress(const std::vector<Step>& steps) {
  if (quiet_) return;
  if (!terminal_) {
    last_.resize(steps.size());
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const std::string line = line_of(steps[k]);
      if (!line.empty() && line != last_[k]) {
        std::cerr << "tribolog: " << printable(line, longest_line) << '\n';
      }
      last_[k] = line;
    }
    return;
  }
  if (is_too_early()) return;
  std::string drawing = back_to_first_line(lines_drawn_);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (k > 0) drawing += '\n';
    drawing += "\r\x1b[K" + bar_of(steps[k]);
  }
  std::cerr << drawing << std::flush;
  lines_drawn_ = static_cast<int>(steps.size());
}

void Console::finish() {
  if (lines_drawn_ > 0) std::cerr << back_to_first_line(lines_drawn_) << "\r\x1b[J" << std::flush;
  lines_drawn_ = 0;
}

void Console::say(const std::string& line) {
  finish();
  if (quiet_) return;
  if (is_output_elsewhere_) {
    std::cerr << lines_for_terminal(line) + "\n";
  } else {
    print(lines_for_terminal(line) + "\n");
  }
}

void Console::make_way_for(const std::string& output) {
  if (is_standard_output(output)) is_output_elsewhere_ = true;
}

void Console::warn(const std::string& line) {
  finish();
  std::cerr << "tribolog: " << lines_for_terminal(line) << '\n';
}

}  // namespace tribolog::cli
