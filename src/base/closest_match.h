#pragma once
// "Did you mean ...?"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tribolog {

/// The candidate that `word` most likely stands for: by edit distance without regard to case, and
/// by one containing the other ("tau" in "tau_Nm"). Empty where none is close. Of equally close
/// ones the first.
std::string closest_match(std::string_view word, const std::vector<std::string>& candidates);

/// "did you mean 'tau_Nm'?", or empty where nothing is close.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// "'t_s', 'q_rad', 'tau_Nm'", each made printable; from `limit` names on: "... and 12 more".
std::string list_of_names(const std::vector<std::string>& names, std::size_t limit = 24);

/// A text from a file in single quotes, made printable.
std::string in_quotes(std::string_view text);

}  // namespace tribolog
