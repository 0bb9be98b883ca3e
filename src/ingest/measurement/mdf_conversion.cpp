#include "ingest/measurement/mdf_conversion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace tribolog::ingest::measurement {

const std::vector<std::string>& MdfConversion::words() const {
  static const std::vector<std::string> none;
  return none;
}

namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

/// As cc_type states them.
enum class ConversionType : std::uint8_t {
  none = 0,
  linear = 1,
  rational = 2,
  formula = 3,
  interpolated = 4,
  nearest = 5,
  ranges = 6,
  texts = 7,
  texts_of_ranges = 8,
  of_text = 9,
  text_to_text = 10,
  texts_of_bits = 11,
};

class Linear final : public MdfConversion {
 public:
  Linear(double offset, double factor) : offset_(offset), factor_(factor) {}
  [[nodiscard]] double value(double raw, bool /*is_integer*/) const override {
    return offset_ + factor_ * raw;
  }

 private:
  double offset_;
  double factor_;
};

class Rational final : public MdfConversion {
 public:
  explicit Rational(const std::array<double, 6>& p) : p_(p) {}
  [[nodiscard]] double value(double raw, bool /*is_integer*/) const override {
    return (p_[0] * raw * raw + p_[1] * raw + p_[2]) / (p_[3] * raw * raw + p_[4] * raw + p_[5]);
  }

 private:
  std::array<double, 6> p_;
};

/// Beyond its ends a table has the values of its ends.
class ValueTable final : public MdfConversion {
 public:
  ValueTable(std::vector<double> keys, std::vector<double> values, bool is_interpolated)
      : keys_(std::move(keys)), values_(std::move(values)), is_interpolated_(is_interpolated) {}

  [[nodiscard]] double value(double raw, bool /*is_integer*/) const override {
    if (std::isnan(raw)) return gap;
    const auto above = std::upper_bound(keys_.begin(), keys_.end(), raw);
    const auto next = static_cast<std::size_t>(above - keys_.begin());
    if (next == 0) return values_.front();
    if (next == keys_.size()) return values_.back();
    const double below = raw - keys_[next - 1];
    const double width = keys_[next] - keys_[next - 1];
    if (!is_interpolated_) return below > width - below ? values_[next] : values_[next - 1];
    return values_[next - 1] + (values_[next] - values_[next - 1]) / width * below;
  }

 private:
  std::vector<double> keys_;
  std::vector<double> values_;
  bool is_interpolated_;
};

struct Range {
  double least{};
  double most{};
};

/// Ranges in ascending order that share at most their ends.
class Ranges {
 public:
  /// @throw UnreadChannel: they are not so.
  explicit Ranges(std::vector<Range> ranges) : ranges_(std::move(ranges)) {
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      const bool is_ordered = ranges_[i].least <= ranges_[i].most &&
                              (i == 0 || ranges_[i - 1].most <= ranges_[i].least);
      if (!is_ordered) throw UnreadChannel("the ranges of its conversion are in no order");
    }
  }

  /// The place of the range that holds a number; as many as there are, where none does.
  [[nodiscard]] std::size_t place_of(double raw, bool is_integer) const {
    const auto above =
        std::upper_bound(ranges_.begin(), ranges_.end(), raw,
                         [](double value, const Range& range) { return value < range.least; });
    // Two ranges may share an end: the later one starts there.
    for (auto it = above; it != ranges_.begin() && above - it < 2;) {
      --it;
      const bool is_in = raw < it->most || (raw == it->most && (is_integer || it->least == raw));
      if (is_in) return static_cast<std::size_t>(it - ranges_.begin());
    }
    return ranges_.size();
  }

 private:
  std::vector<Range> ranges_;
};

class ValuesOfRanges final : public MdfConversion {
 public:
  ValuesOfRanges(Ranges ranges, std::vector<double> values)
      : ranges_(std::move(ranges)), values_(std::move(values)) {}
  [[nodiscard]] double value(double raw, bool is_integer) const override {
    return values_[ranges_.place_of(raw, is_integer)];
  }

 private:
  Ranges ranges_;
  std::vector<double> values_;  ///< Behind those of the ranges that of all other numbers.
};

/// What a key of a table of texts leads to: a text, a conversion of its own, or nothing.
struct Target {
  double word{gap};
  std::shared_ptr<const MdfConversion> conversion;
  bool is_raw{};  ///< A conversion that changes nothing.
};

class Texts final : public MdfConversion {
 public:
  Texts(Ranges ranges, std::vector<Target> targets, std::vector<std::string> words)
      : ranges_(std::move(ranges)), targets_(std::move(targets)), words_(std::move(words)) {
    has_numbers_ = std::any_of(targets_.begin(), targets_.end(), [](const Target& target) {
      return target.conversion != nullptr || target.is_raw;
    });
    if (has_numbers_) words_.clear();
  }

  [[nodiscard]] double value(double raw, bool is_integer) const override {
    const Target& target = targets_[ranges_.place_of(raw, is_integer)];
    if (!has_numbers_) return target.word;
    if (target.is_raw) return raw;
    return target.conversion ? target.conversion->value(raw, is_integer) : gap;
  }
  [[nodiscard]] const std::vector<std::string>& words() const override { return words_; }

 private:
  Ranges ranges_;
  std::vector<Target> targets_;  ///< Behind those of the ranges that of all other numbers.
  std::vector<std::string> words_;
  bool has_numbers_{};
};

constexpr std::size_t values_at = 24;  ///< Of a ##CC's data.
constexpr std::size_t text_links_at = 4;

std::size_t values_of(const MdfBlock& block) {
  const std::size_t stated = block.uint16(6);
  return std::min(stated, (std::max(block.data().size(), values_at) - values_at) / 8);
}

double value_of(const MdfBlock& block, std::size_t index) {
  return block.float64(values_at + 8 * index);
}

[[noreturn]] void refuse_short(std::size_t values) {
  throw UnreadChannel(fmt::format("its conversion is damaged: it has {} numbers", values));
}

std::shared_ptr<const MdfConversion> read_table(const MdfBlock& block, bool is_interpolated) {
  const std::size_t count = values_of(block) / 2;
  if (count == 0) refuse_short(values_of(block));
  std::vector<double> keys;
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    keys.push_back(value_of(block, 2 * i));
    values.push_back(value_of(block, 2 * i + 1));
    const bool is_ordered = std::isfinite(keys.back()) && (i == 0 || keys[i - 1] < keys[i]);
    if (!is_ordered) throw UnreadChannel("the table of its conversion is in no order");
  }
  return std::make_shared<ValueTable>(std::move(keys), std::move(values), is_interpolated);
}

std::shared_ptr<const MdfConversion> read_ranges(const MdfBlock& block) {
  const std::size_t count = values_of(block);
  if (count % 3 != 1) refuse_short(count);
  std::vector<Range> ranges;
  std::vector<double> values;
  for (std::size_t i = 0; i + 3 <= count; i += 3) {
    ranges.push_back({value_of(block, i), value_of(block, i + 1)});
    values.push_back(value_of(block, i + 2));
  }
  values.push_back(value_of(block, count - 1));
  return std::make_shared<ValuesOfRanges>(Ranges(std::move(ranges)), std::move(values));
}

}  // namespace

UnitConversion MdfConversions::conversion(MdfLink link, int depth) {
  constexpr int deepest = 4;
  if (link == 0) return {};
  if (const auto known = known_.find(link); known != known_.end()) return known->second;
  if (depth > deepest) throw UnreadChannel("its conversion refers to others without end");
  const MdfBlock block = blocks_.block(link, {"##CC"});
  UnitConversion result{read(block, depth), blocks_.text(block.link(1))};
  return known_.emplace(link, std::move(result)).first->second;
}

std::shared_ptr<const MdfConversion> MdfConversions::read(const MdfBlock& block, int depth) {
  const auto parameter = [&](std::size_t index) { return value_of(block, index); };
  const std::uint8_t type = block.uint8(0);
  switch (static_cast<ConversionType>(type)) {
    case ConversionType::none:
      return nullptr;
    case ConversionType::linear:
      if (values_of(block) < 2) refuse_short(values_of(block));
      return std::make_shared<Linear>(parameter(0), parameter(1));
    case ConversionType::rational:
      if (values_of(block) < 6) refuse_short(values_of(block));
      return std::make_shared<Rational>(std::array{parameter(0), parameter(1), parameter(2),
                                                   parameter(3), parameter(4), parameter(5)});
    case ConversionType::formula:
      throw UnreadChannel("its conversion is a formula");
    case ConversionType::interpolated:
      return read_table(block, true);
    case ConversionType::nearest:
      return read_table(block, false);
    case ConversionType::ranges:
      return read_ranges(block);
    case ConversionType::texts:
      return read_texts(block, 1, depth);
    case ConversionType::texts_of_ranges:
      return read_texts(block, 2, depth);
    case ConversionType::of_text:
    case ConversionType::text_to_text:
      throw UnreadChannel("it holds texts");
    case ConversionType::texts_of_bits:
      throw UnreadChannel("its conversion gives a text for each of its bits");
  }
  throw UnreadChannel(fmt::format("its conversion is of type {}", type));
}

std::shared_ptr<const MdfConversion> MdfConversions::read_texts(const MdfBlock& block,
                                                                std::size_t values_each,
                                                                int depth) {
  const std::size_t count = values_of(block) / values_each;
  std::vector<std::pair<Range, Target>> entries;
  std::vector<std::string> words;
  const auto target_of = [&](std::size_t index) {
    Target target;
    const MdfLink link = block.link(text_links_at + index);
    if (link == 0) return target;
    if (blocks_.mark_at(link) == "##CC") {
      const UnitConversion nested = conversion(link, depth + 1);
      if (nested.conversion && !nested.conversion->words().empty()) {
        throw UnreadChannel("its conversion gives words by another one");
      }
      target.conversion = nested.conversion;
      target.is_raw = nested.conversion == nullptr;
      return target;
    }
    const std::string word = blocks_.text(link);
    const auto known = std::find(words.begin(), words.end(), word);
    target.word = static_cast<double>(known - words.begin());
    if (known == words.end()) words.push_back(word);
    constexpr std::size_t most_words = 1000;
    if (words.size() > most_words) throw UnreadChannel("it has more than 1000 words");
    return target;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const double least = value_of(block, values_each * i);
    const double most = value_of(block, values_each * i + values_each - 1);
    entries.emplace_back(Range{least, most}, target_of(i));
  }
  const auto is_before = [](const auto& a, const auto& b) { return a.first.least < b.first.least; };
  if (!std::all_of(entries.begin(), entries.end(),
                   [](const auto& entry) { return std::isfinite(entry.first.least); })) {
    throw UnreadChannel("the table of its conversion is in no order");
  }
  std::stable_sort(entries.begin(), entries.end(), is_before);
  std::vector<Range> ranges;
  std::vector<Target> targets;
  for (auto& [range, target] : entries) {
    ranges.push_back(range);
    targets.push_back(std::move(target));
  }
  targets.push_back(target_of(count));
  return std::make_shared<Texts>(Ranges(std::move(ranges)), std::move(targets), std::move(words));
}

}  // namespace tribolog::ingest::measurement
