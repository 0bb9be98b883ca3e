#include "base/standard_output.h"

#include <cerrno>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "base/error.h"
#include "base/file_descriptor.h"

namespace tribolog {
namespace {

int failure = 0;  // the first one's errno

/// Some file systems tell only at the end that there was no room.
int late_failure() {
  const int same = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
  if (same < 0) return 0;  // too many files are open
  return ::close(same) == 0 || errno == EINTR ? 0 : errno;
}

}  // namespace

void keep_standard_streams_open() {
  // Opened the wrong way round, so that reading and writing fail as from a closed stream. Each
  // takes the lowest number that is free, which is its own.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
    if (::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

void print(std::string_view bytes) {
  if (failure == 0) failure = write_all(STDOUT_FILENO, bytes);
}

void finish_printing() {
  if (failure == 0) failure = late_failure();
  if (failure == 0 || failure == EPIPE) return;
  throw OutputError("standard output: cannot write: " +
                    (failure == EBADF ? "it is closed" : std::generic_category().message(failure)));
}

}  // namespace tribolog
