#include "api/guard.h"

#include <algorithm>
#include <exception>
#include <new>
#include <vector>

#include "base/error.h"
#include "base/program_module.h"
#include "tribolog/failure.h"
#include "wording/words.h"

namespace tribolog::api {
namespace {

Failure::Kind kind_of(ExitStatus status) {
  switch (status) {
    case ExitStatus::usage:
      return Failure::Kind::usage;
    case ExitStatus::input_refused:
      return Failure::Kind::input_refused;
    case ExitStatus::output_failed:
      return Failure::Kind::output_failed;
    case ExitStatus::figure_failed:
      return Failure::Kind::figure_failed;
    case ExitStatus::archive_failed:
      return Failure::Kind::archive_failed;
    case ExitStatus::done:
    case ExitStatus::verdict_failed:
    case ExitStatus::internal:
      break;
  }
  return Failure::Kind::internal;
}

}  // namespace

void throw_as_failure() {
  try {
    throw;
  } catch (const Failure&) {
    throw;
  } catch (const InputError& error) {
    const Location& where = error.where();
    throw Failure(Failure::Kind::input_refused, error.what(), where.file, where.line, where.column);
  } catch (const Error& error) {
    throw Failure(kind_of(error.status()), wording::words(error));
  } catch (const MissingModule& missing) {
    throw Failure(Failure::Kind::missing_library, missing.what());
  } catch (const std::bad_alloc&) {
    throw Failure(Failure::Kind::out_of_memory, "out of memory");
  } catch (const std::exception& error) {
    throw Failure(Failure::Kind::internal, wording::words(error));
  }
}

wording::Language language_of(const std::string& code) {
  const std::vector<wording::Language> all = wording::languages();
  const auto found = std::find(all.begin(), all.end(), wording::Language{code});
  if (found != all.end()) return *found;
  std::string known;
  for (const wording::Language& one : all) known += (known.empty() ? "" : ", ") + one.code;
  throw UsageError("there is no language '" + printable(code) + "'; there are " + known);
}

}  // namespace tribolog::api
