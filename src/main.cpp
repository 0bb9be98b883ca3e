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
#include "tribolog/failure.h"
#include "wording/words.h"

namespace tribolog {
namespace {

constexpr std::size_t longest_message = 10'000;

/// An archive that says of itself that nothing was changed knows nothing of the other outputs.
std::string with_what_was_kept(std::string message, ExitStatus status) {
  const bool is_of_outputs =
      status == ExitStatus::output_failed || status == ExitStatus::archive_failed;
  if (!is_of_outputs || !is_something_kept()) return message;
  constexpr std::string_view nothing = "; nothing was changed";
  if (message.ends_with(nothing)) message.resize(message.size() - nothing.size());
  return message + "; " + kept_in_words();
}

void tell_refusal(const std::string& message, ExitStatus status) {
  std::cerr << "tribolog: error: " +
                   printable(with_what_was_kept(message, status), longest_message) + "\n";
}

void print_shortage(const std::string& what) {
  std::cerr << "tribolog: error: " + what + "; " + kept_in_words() + "\n";
}

void tell_fault(const std::string& what) {
  std::cerr << "tribolog: internal error: " << printable(what, longest_message)
            << "; please report it with the command and its input\n";
}

/// Of what goes through the door.
void tell(const Failure& failure) {
  switch (failure.kind()) {
    case Failure::Kind::usage:
    case Failure::Kind::input_refused:
    case Failure::Kind::output_failed:
    case Failure::Kind::figure_failed:
    case Failure::Kind::archive_failed:
      return tell_refusal(failure.what(), static_cast<ExitStatus>(failure.exit_status()));
    case Failure::Kind::missing_library:
    case Failure::Kind::out_of_memory:
      return print_shortage(failure.what());
    case Failure::Kind::internal:
      return tell_fault(failure.what());
  }
}

int run(int argc, char** argv) {
  try {
    const ExitStatus status = cli::run_command_line(argc, argv);
    finish_printing();
    return static_cast<int>(status);
  } catch (const Error& error) {
    tell_refusal(wording::words(error), error.status());
    return static_cast<int>(error.status());
  } catch (const Failure& failure) {
    tell(failure);
    return failure.exit_status();
  } catch (const MissingModule& missing) {
    print_shortage(missing.what());
  } catch (const std::bad_alloc&) {
    print_shortage("out of memory");
  } catch (const std::exception& error) {
    tell_fault(wording::words(error));
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
