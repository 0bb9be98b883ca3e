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

}  // namespace

Console::Console(bool quiet)
    : quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()) {}

Console::~Console() { finish(); }

void Console::progress(const std::string& what, std::size_t done, std::size_t all) {
  if (quiet_ || all == 0) return;
  if (!terminal_) {
    if (what != last_) std::cerr << "tribolog: " << printable(what, longest_line) << '\n';
    last_ = what;
    return;
  }
  using std::chrono::steady_clock;
  if (!drawn_ && steady_clock::now() - start_ < std::chrono::seconds(1)) return;
  constexpr std::size_t width = 30;
  const std::size_t filled = width * done / all;
  std::cerr << fmt::format("\r\x1b[K[{}{}] {}/{} {}", std::string(filled, '#'),
                           std::string(width - filled, '.'), done, all,
                           printable(what, longest_bar_text))
            << std::flush;
  drawn_ = true;
}

void Console::finish() {
  if (drawn_) std::cerr << "\r\x1b[K" << std::flush;
  drawn_ = false;
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
