// Arguments -> command -> exit status. Every error becomes one clear line and its status.

#include <csignal>
#include <cstddef>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/early_end.h"
#include "base/error.h"
#include "base/program_module.h"
#include "base/standard_output.h"
#include "cli/command_line.h"
#include "wording/words.h"

namespace tribolog {
namespace {

constexpr std::size_t longest_message = 10'000;

/// An archive that says of itself that nothing was changed knows nothing of the other outputs.
std::string with_what_was_kept(const Error& error) {
  std::string message = wording::words(error);
  const bool is_of_outputs =
      error.status() == ExitStatus::output_failed || error.status() == ExitStatus::archive_failed;
  if (!is_of_outputs || !is_something_kept()) return message;
  constexpr std::string_view nothing = "; nothing was changed";
  if (message.ends_with(nothing)) message.resize(message.size() - nothing.size());
  return message + "; " + kept_in_words();
}

int run(int argc, char** argv) {
  try {
    const ExitStatus status = cli::run_command_line(argc, argv);
    finish_printing();
    return static_cast<int>(status);
  } catch (const Error& error) {
    std::cerr << "tribolog: error: " + printable(with_what_was_kept(error), longest_message) + "\n";
    return static_cast<int>(error.status());
  } catch (const MissingModule& missing) {
    std::cerr << "tribolog: error: " << missing.what() << "; " << kept_in_words() << '\n';
  } catch (const std::bad_alloc&) {
    std::cerr << "tribolog: error: out of memory; " << kept_in_words() << '\n';
  } catch (const std::exception& error) {
    std::cerr << "tribolog: internal error: " << printable(wording::words(error), longest_message)
              << "; please report it with the command and its input\n";
  }
  return static_cast<int>(ExitStatus::internal);
}

}  // namespace
}  // namespace tribolog

int main(int argc, char** argv) {
  tribolog::keep_standard_streams_open();
  // A reader that goes away (| head) is no fault: writing fails quietly instead of killing us.
  std::signal(SIGPIPE, SIG_IGN);
  tribolog::end_cleanly_on_signals();
  return tribolog::run(argc, argv);
}
