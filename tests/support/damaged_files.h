#pragma once
// Files with one thing wrong, from a good one: what a reader must answer with a table or a refusal.

#include <cstddef>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/breadth.h"

namespace tribolog::test {

/// A table, or one line of refusal; anything else fails the test.
template <class Read>
void expect_answer(const Read& read, const std::string& bytes, const std::string& what) {
  try {
    (void)read(bytes);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << what;
  } catch (const std::exception& error) {
    ADD_FAILURE() << what << ": " << error.what();
  }
}

/// Cuts the file at `count` random places.
template <class Read>
void expect_cuts_answered(const Read& read, const std::string& bytes, std::size_t count) {
  std::mt19937 random(1);
  for (std::size_t i = 0; i < seeds_of(count / 4, count); ++i) {
    const std::size_t length = i < 20 ? i : random() % bytes.size();
    expect_answer(read, bytes.substr(0, length), "first " + std::to_string(length) + " bytes");
  }
}

/// Changes one random byte at a time to another one, `count` times.
template <class Read>
void expect_changes_answered(const Read& read, const std::string& bytes, std::size_t count) {
  std::mt19937 random(2);
  for (std::size_t i = 0; i < seeds_of(count / 4, count); ++i) {
    const std::size_t at = random() % bytes.size();
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ static_cast<char>(1 + random() % 255));
    expect_answer(read, changed, "byte " + std::to_string(at) + " changed");
  }
}

/// Damages the file in `count` ways: a bit turned, bytes changed, the end cut off, a piece of it
/// put over or into another place.
template <class Read>
void expect_mutants_answered(const Read& read, const std::string& bytes, std::size_t count) {
  std::mt19937 random(3);
  const auto below = [&](std::size_t bound) { return random() % bound; };
  for (std::size_t i = 0; i < count; ++i) {
    std::string mutant = bytes;
    const std::size_t at = below(bytes.size());
    const std::string piece = bytes.substr(below(bytes.size()), 1 + below(64));
    switch (i % 5) {
      case 0:
        mutant[at] = static_cast<char>(mutant[at] ^ static_cast<char>(1U << below(8)));
        break;
      case 1:
        for (std::size_t k = 0; k < 4 && at + k < mutant.size(); ++k) {
          mutant[at + k] = static_cast<char>(random() % 256);
        }
        break;
      case 2:
        mutant.resize(at);
        break;
      case 3:
        mutant.replace(at, piece.size(), piece);
        break;
      default:
        mutant.insert(at, piece);
    }
    expect_answer(read, mutant, "mutant " + std::to_string(i) + " at byte " + std::to_string(at));
  }
}

}  // namespace tribolog::test
