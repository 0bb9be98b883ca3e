#pragma once
// How many inputs were read and how many were refused: a target whose every input is refused at
// the door tests nothing, however long it runs.

#include <cstdio>

#include "base/error.h"

namespace tribolog::fuzz {

/// Told on standard error when the process ends: "outcomes: 12 read, 88 refused".
class Outcomes {
 public:
  Outcomes() = default;
  Outcomes(const Outcomes&) = delete;
  Outcomes& operator=(const Outcomes&) = delete;
  ~Outcomes() { std::fprintf(stderr, "outcomes: %zu read, %zu refused\n", read_, refused_); }

  void count(bool was_read) { ++(was_read ? read_ : refused_); }

 private:
  std::size_t read_{0};
  std::size_t refused_{0};
};

inline void count_outcome(bool was_read) {
  static Outcomes outcomes;
  outcomes.count(was_read);
}

/// Runs `read`, which may refuse its input with an InputError and with nothing else.
template <typename Read>
void read_or_refuse(const Read& read) {
  bool was_read = true;
  try {
    read();
  } catch (const InputError&) {
    was_read = false;
  }
  count_outcome(was_read);
}

}  // namespace tribolog::fuzz
