#include "joint/allowed_resamples.h"

#include <fmt/format.h>

namespace tribolog {

bool resamples_are_allowed(std::uint64_t resamples) {
  return resamples == 0 || (resamples >= fewest_resamples && resamples <= most_resamples);
}

std::string allowed_resamples_in_words() {
  return fmt::format("0 (closed forms alone), or {} to {}", fewest_resamples, most_resamples);
}

}  // namespace tribolog
