#pragma once
// Texts of enumerators, both ways: their own names, or those of a table that the compiler counts.
//
// Where a file or a message code holds a name, renaming the enumerator renames it there as well.
// Enumerators are counted from 0 and leave none out, 64 of them at most.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tribolog {

/// "rough_sweep" for Role::rough_sweep; empty for a value that is no enumerator.
template <auto value>
consteval auto name_of_enumerator() {
  std::string_view text =
      __PRETTY_FUNCTION__;  // "... [with auto value = joint::Role::rough_sweep]"
  constexpr std::string_view mark = "value = ";
  text.remove_prefix(text.find(mark) + mark.size());
  text = text.substr(0, text.find_first_of(";]"));
  const bool is_number = text.starts_with('(');  // "(joint::Role)6"
  return is_number ? std::string_view{} : text.substr(text.rfind(':') + 1);
}

template <typename Enum, std::size_t count = 0>
consteval std::size_t count_of_enumerators() {
  if constexpr (count < 64 && !name_of_enumerator<static_cast<Enum>(count)>().empty()) {
    return count_of_enumerators<Enum, count + 1>();
  } else {
    return count;
  }
}

/// One text for each enumerator, in the order of the enumeration.
template <typename Enum>
class EnumTexts {
 public:
  static constexpr std::size_t size = count_of_enumerators<Enum>();
  static_assert(size > 0 && size < 64);

  /// Their own names.
  consteval EnumTexts() : EnumTexts(std::make_index_sequence<size>()) {}

  template <typename... Texts>
    requires(sizeof...(Texts) == size)
  explicit consteval EnumTexts(Texts... texts) : texts_{texts...} {}

  [[nodiscard]] constexpr std::string_view of(Enum value) const {
    return texts_.at(static_cast<std::size_t>(value));
  }

  /// Nothing for a text that none of them has: a file may be of another version.
  [[nodiscard]] constexpr std::optional<Enum> find(std::string_view text) const {
    for (std::size_t i = 0; i < size; ++i) {
      if (texts_[i] == text) return static_cast<Enum>(i);
    }
    return std::nullopt;
  }

  [[nodiscard]] std::vector<std::string> all() const { return {texts_.begin(), texts_.end()}; }

 private:
  template <std::size_t... places>
  explicit consteval EnumTexts(std::index_sequence<places...> /*places*/)
      : texts_{name_of_enumerator<static_cast<Enum>(places)>()...} {}

  std::array<std::string_view, size> texts_;
};

/// The enumerators' own names.
template <typename Enum>
inline constexpr EnumTexts<Enum> own_names{};

template <typename Enum>
std::string own_name(Enum value) {
  return std::string(own_names<Enum>.of(value));
}

}  // namespace tribolog
