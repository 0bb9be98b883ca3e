#pragma once
// The edge of the door: inside errors have many types, outside one.

#include <string>

#include "wording/language.h"

namespace tribolog::api {

/// The exception that is being handled, as a Failure. To be called in a catch block.
[[noreturn]] void throw_as_failure();

/// What `work` gives. @throw Failure in place of whatever it throws.
template <class Work>
auto guarded(const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (...) {
    throw_as_failure();
  }
}

/// @throw UsageError: there is no such language.
wording::Language language_of(const std::string& code);

}  // namespace tribolog::api
