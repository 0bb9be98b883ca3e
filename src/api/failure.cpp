#include "tribolog/failure.h"

#include "base/error.h"

namespace tribolog {

Failure::Failure(Kind kind, const std::string& message, const std::string& file, long line,
                 long column)
    : std::runtime_error(message), kind_(kind), file_(file), line_(line), column_(column) {}

Failure::~Failure() = default;

int Failure::exit_status() const noexcept {
  switch (kind_) {
    case Kind::usage:
      return static_cast<int>(ExitStatus::usage);
    case Kind::input_refused:
      return static_cast<int>(ExitStatus::input_refused);
    case Kind::output_failed:
      return static_cast<int>(ExitStatus::output_failed);
    case Kind::figure_failed:
      return static_cast<int>(ExitStatus::figure_failed);
    case Kind::archive_failed:
      return static_cast<int>(ExitStatus::archive_failed);
    case Kind::missing_library:
    case Kind::out_of_memory:
    case Kind::internal:
      break;
  }
  return static_cast<int>(ExitStatus::internal);
}

}  // namespace tribolog
