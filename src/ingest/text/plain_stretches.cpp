#include "ingest/text/plain_stretches.h"

#include <algorithm>
#include <utility>

#include "base/parallel_for.h"

namespace tribolog {
namespace {

constexpr std::size_t stretch_bytes = std::size_t{1} << 19;

/// Starting a thread takes longer than reading a few lines.
std::size_t threads_for(std::size_t bytes) {
  constexpr std::size_t few_bytes = std::size_t{1} << 16;
  return bytes < few_bytes ? 1 : 0;
}

/// Of whole lines, about half a megabyte each.
std::vector<std::string_view> stretches_of(std::string_view text) {
  std::vector<std::string_view> stretches;
  while (!text.empty()) {
    const std::size_t bytes = std::min(stretch_bytes, text.size());
    const std::size_t line_end = text.substr(0, bytes).rfind('\n');
    if (line_end == std::string_view::npos) break;  // a long line, or the last one
    stretches.push_back(text.substr(0, line_end + 1));
    text.remove_prefix(line_end + 1);
  }
  return stretches;
}

}  // namespace

PlainStretches::Round PlainStretches::read(std::string_view text, const PlainLayout& layout,
                                           const std::function<void()>& meanwhile) {
  const std::vector<std::string_view> stretches = stretches_of(text);
  if (parts_.size() < stretches.size()) parts_.resize(stretches.size());
  const std::size_t columns = waiting_parts_ > 0 ? columns_.size() : 0;
  const auto work = [&](std::size_t k) {
    if (k == 0) {
      meanwhile();
    } else if (k <= columns) {
      append(k - 1);
    } else {
      const std::size_t i = k - 1 - columns;
      read_plain_rows(stretches[i], layout, parts_[i]);
    }
  };
  parallel_for(1 + columns + stretches.size(), work, threads_for(waiting_bytes_ + text.size()));
  waiting_bytes_ = text.size();
  const auto end = parts_.begin() + static_cast<std::ptrdiff_t>(stretches.size());
  const auto last =
      std::find_if(parts_.begin(), end, [](const PlainRows& part) { return !part.is_whole; });
  const bool is_whole = last == end;
  waiting_parts_ = static_cast<std::size_t>(last - parts_.begin()) + (is_whole ? 0 : 1);
  std::swap(parts_, waiting_);
  return {std::span(waiting_).first(waiting_parts_), is_whole && !stretches.empty()};
}

void PlainStretches::finish() {
  if (waiting_parts_ > 0) {
    parallel_for(columns_.size(), [&](std::size_t k) { append(k); }, threads_for(waiting_bytes_));
  }
  waiting_parts_ = 0;
}

void PlainStretches::append(std::size_t column) {
  LogColumn& to = columns_[column];
  for (const PlainRows& part : std::span(waiting_).first(waiting_parts_)) {
    const double* const first = part.values[column].data();
    to.values.insert(to.values.end(), first, first + part.rows);
    to.gaps += part.gaps[column];
  }
}

}  // namespace tribolog
