#pragma once
// A message with places for what differs from one use to the next, and its translation.
//
// A source message: "{n} of {n} samples of {}". Each place takes a text that is not empty:
//   {}   any; it stands in the translation as it is (names, formulas, numbers with units)
//   {n}  a number as the report writes it: "3", "−0.0043", "1.2e-5", "3.8832 ± 0.0043"
//   {t}  any; it is translated itself
// The translation names them by their order, from 0: "{0} z {1} próbek: {2}". A word that follows
// a number takes the forms of one, of two to four and of five: "{0} {0|próbka|próbki|próbek}".

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tribolog::wording {

/// What stood in the places of a message.
struct PlacedText {
  std::string_view text;
  bool is_translated{};  ///< Stood in a {t}.
};

class MessagePattern {
 public:
  /// @throw std::invalid_argument naming what is wrong with the message: a place that is not
  ///        closed or of no known kind, two places without text between them.
  explicit MessagePattern(std::string_view message);

  [[nodiscard]] bool has_places() const { return !kinds_.empty(); }
  [[nodiscard]] std::size_t places() const { return kinds_.size(); }
  /// Characters outside of the places: the more, the more a match says.
  [[nodiscard]] std::size_t own_length() const { return own_length_; }

  /// The texts in the places, where the whole text is this message. Of several ways the one whose
  /// first places are shortest. A text that could be cut in very many ways is taken for another
  /// one after most_tries.
  [[nodiscard]] std::optional<std::vector<PlacedText>> match(std::string_view text) const;

 private:
  enum class Kind { any, number, translated };
  static constexpr int most_tries = 10'000;
  bool match_from(std::size_t place, std::string_view rest, std::vector<PlacedText>& found,
                  int& tries) const;
  [[nodiscard]] static bool fits(Kind kind, std::string_view text);

  std::vector<std::string> literals_;  ///< Around the places: one more than there are places.
  std::vector<Kind> kinds_;
  std::size_t own_length_{0};
};

/// The translation with the texts in their places.
/// @throw std::invalid_argument for a place that the message has not, or that is not closed.
std::string fill_places(std::string_view translation, const std::vector<std::string>& texts);

/// Which of three forms a Polish word takes behind a number: 0 for 1; 1 for 2 to 4, but not for 12
/// to 14; 2 for all others and for fractions and what is no number.
int plural_form(std::string_view number);

}  // namespace tribolog::wording
