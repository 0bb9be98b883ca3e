#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <utility>

#include "render/png/png_encoder.h"

namespace tribolog::render::png {
namespace {

using Key = std::uint32_t;

struct Occurrence {
  Key key{};
  std::uint32_t count{};
};

/// Colours numbered in the order in which they appear.
class ColourTable {
 public:
  /// Nothing if the table is full.
  std::optional<std::uint16_t> number(Key key) {
    std::size_t slot = (key * 2654435761U) >> (32U - slot_bits);
    while (slots_[slot] != free_slot && colours_[slots_[slot]].key != key) {
      slot = (slot + 1) % slots_.size();
    }
    if (slots_[slot] == free_slot) {
      if (colours_.size() == most_colours) return std::nullopt;
      slots_[slot] = static_cast<std::uint16_t>(colours_.size());
      colours_.push_back({key, 0});
    }
    return slots_[slot];
  }
  [[nodiscard]] std::vector<Occurrence>& colours() { return colours_; }

 private:
  static constexpr unsigned slot_bits = 12;
  static constexpr std::size_t most_colours = 1024;
  static constexpr std::uint16_t free_slot = 0xFFFF;
  std::vector<std::uint16_t> slots_ = std::vector<std::uint16_t>(1U << slot_bits, free_slot);
  std::vector<Occurrence> colours_;
};

int channel(Key key, unsigned which) { return static_cast<int>((key >> (8 * which)) & 0xFFU); }

int distance(Key a, Key b) {
  int largest = 0;
  for (const unsigned which : {0U, 1U, 2U}) {
    largest = std::max(largest, std::abs(channel(a, which) - channel(b, which)));
  }
  return largest;
}

/// Takes colours away until 256 are left, each time the one whose place, and those that it had
/// taken itself, another colour takes with the least error; of equal ones the rarest.
class PaletteChoice {
 public:
  explicit PaletteChoice(const std::vector<Occurrence>& colours)
      : colours_(colours),
        kept_(colours.size(), true),
        nearest_(colours.size()),
        stands_for_within_(colours.size()) {
    if (colours.size() <= most) return;
    for (std::size_t i = 0; i < colours.size(); ++i) find_nearest(i);
    for (std::size_t left = colours.size(); left > most; --left) remove_one();
  }

  /// Three bytes a colour, in order of appearance.
  [[nodiscard]] std::vector<std::uint8_t> palette() const {
    std::vector<std::uint8_t> out;
    for (std::size_t i = 0; i < colours_.size(); ++i) {
      if (!kept_[i]) continue;
      for (const unsigned which : {0U, 1U, 2U}) {
        out.push_back(static_cast<std::uint8_t>(channel(colours_[i].key, which)));
      }
    }
    return out;
  }

  /// For each colour its place in the palette.
  [[nodiscard]] std::vector<std::uint8_t> places() const {
    std::vector<std::uint8_t> out(colours_.size());
    std::uint8_t next = 0;
    for (std::size_t i = 0; i < colours_.size(); ++i) {
      if (kept_[i]) out[i] = next++;
    }
    for (std::size_t i = 0; i < colours_.size(); ++i) {
      if (!kept_[i]) out[i] = out[nearest_[i].other];
    }
    return out;
  }

  [[nodiscard]] int largest_error() const {
    int largest = 0;
    for (std::size_t i = 0; i < colours_.size(); ++i) {
      if (!kept_[i]) largest = std::max(largest, nearest_[i].distance);
    }
    return largest;
  }

 private:
  static constexpr std::size_t most = 256;
  struct Neighbour {
    std::size_t other{};
    int distance{};
  };

  void find_nearest(std::size_t i) {
    nearest_[i].distance = std::numeric_limits<int>::max();
    for (std::size_t k = 0; k < colours_.size(); ++k) {
      if (k == i || !kept_[k]) continue;
      const int d = distance(colours_[i].key, colours_[k].key);
      if (d < nearest_[i].distance) nearest_[i] = {k, d};
    }
  }

  /// At most so far off are those that this colour stands for, if it goes too.
  [[nodiscard]] int cost(std::size_t i) const {
    return nearest_[i].distance + stands_for_within_[i];
  }

  void remove_one() {
    std::size_t gone = colours_.size();
    for (std::size_t i = 0; i < colours_.size(); ++i) {
      if (!kept_[i]) continue;
      if (gone == colours_.size() || cost(i) < cost(gone) ||
          (cost(i) == cost(gone) && colours_[i].count < colours_[gone].count)) {
        gone = i;
      }
    }
    kept_[gone] = false;
    int& taken_over = stands_for_within_[nearest_[gone].other];
    taken_over = std::max(taken_over, cost(gone));
    for (std::size_t i = 0; i < colours_.size(); ++i) {
      if (nearest_[i].other == gone) find_nearest(i);
    }
  }

  const std::vector<Occurrence>& colours_;
  std::vector<bool> kept_;
  std::vector<Neighbour> nearest_;
  std::vector<int> stands_for_within_;
};

Key key_at(const figure::Picture& picture, std::size_t pixel) {
  const std::uint8_t* const rgb = picture.rgb.data() + 3 * pixel;
  return rgb[0] | (static_cast<Key>(rgb[1]) << 8U) | (static_cast<Key>(rgb[2]) << 16U);
}

/// To one of 9 levels a channel.
Key rounded(Key key) {
  constexpr Key step = 32;
  Key out = 0;
  for (const unsigned shift : {0U, 8U, 16U}) {
    const Key level = (((key >> shift) & 0xFFU) + step / 2) / step * step;
    out |= std::min<Key>(level, 0xFF) << shift;
  }
  return out;
}

struct CountedColours {
  std::vector<std::uint16_t> numbers;  ///< Of the colour of each pixel.
  std::vector<Occurrence> colours;
};

/// Nothing where they are too many.
/// @param round_single_pixels those that differ from both neighbours in their row: of fading
/// edges, where fewer levels do not show.
std::optional<CountedColours> count_colours(const figure::Picture& picture,
                                            bool round_single_pixels) {
  ColourTable table;
  CountedColours out;
  out.numbers.resize(picture.rgb.size() / 3);
  constexpr Key none = 0xFFFFFFFF;
  Key last = none;
  Key key = out.numbers.empty() ? none : key_at(picture, 0);
  for (std::size_t i = 0; i < out.numbers.size(); ++i) {
    const Key next = i + 1 < out.numbers.size() ? key_at(picture, i + 1) : none;
    if (key == last) {
      out.numbers[i] = out.numbers[i - 1];
    } else {
      const bool is_rounded = round_single_pixels && key != next;
      const auto found = table.number(is_rounded ? rounded(key) : key);
      if (!found) return std::nullopt;
      out.numbers[i] = *found;
    }
    ++table.colours()[out.numbers[i]].count;
    last = key;
    key = next;
  }
  out.colours = std::move(table.colours());
  return out;
}

}  // namespace

std::optional<IndexedPicture> indexed(const figure::Picture& picture, SinglePixels single) {
  std::optional<CountedColours> counted = count_colours(picture, false);
  if (!counted && single == SinglePixels::may_be_rounded) counted = count_colours(picture, true);
  if (!counted) return std::nullopt;
  const PaletteChoice choice(counted->colours);
  if (choice.largest_error() > largest_colour_error) return std::nullopt;
  const std::vector<std::uint8_t> places = choice.places();
  IndexedPicture out{choice.palette(), {}};
  out.indices.resize(counted->numbers.size());
  std::transform(counted->numbers.begin(), counted->numbers.end(), out.indices.begin(),
                 [&](std::uint16_t number) { return places[number]; });
  return out;
}

}  // namespace tribolog::render::png
