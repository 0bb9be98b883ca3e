// Arguments -> command -> exit status. Every error becomes one clear line and its status.

#include <csignal>
#include <cstddef>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>

#include "cli/command_line.h"
#include "error.h"

namespace {

constexpr std::size_t longest_message = 10'000;

}  // namespace

int main(int argc, char** argv) {
  using tribolog::ExitStatus;
  using tribolog::printable;
  // A reader that goes away (| head) is no fault: writing fails quietly instead of killing us.
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return static_cast<int>(tribolog::run_command_line(argc, argv));
  } catch (const tribolog::Error& error) {
    std::cerr << "tribolog: error: " << printable(error.what(), longest_message) << '\n';
    return static_cast<int>(error.status());
  } catch (const std::bad_alloc&) {
    std::cerr << "tribolog: error: out of memory; nothing was written\n";
  } catch (const std::exception& error) {
    std::cerr << "tribolog: internal error: " << printable(error.what(), longest_message)
              << "; please report it with the command and its input\n";
  }
  return static_cast<int>(ExitStatus::internal);
}
