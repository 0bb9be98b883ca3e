#pragma once
// From the numbers that a channel stores to those that were measured (##CC).

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "ingest/measurement/mdf_blocks.h"
#include "ingest/measurement/measured_log.h"

namespace tribolog::ingest::measurement {

/// How a raw number becomes a value, or a word.
class MdfConversion {
 public:
  virtual ~MdfConversion() = default;
  MdfConversion() = default;
  MdfConversion(const MdfConversion&) = delete;
  MdfConversion& operator=(const MdfConversion&) = delete;

  /// The value; of words the place among words(). NaN: none, or a text among numbers.
  /// @param is_integer ranges of integers hold their upper end, those of floats do not.
  [[nodiscard]] virtual double value(double raw, bool is_integer) const = 0;
  /// Not empty: the values are their places in this list.
  [[nodiscard]] virtual const std::vector<std::string>& words() const;
};

struct UnitConversion {
  std::shared_ptr<const MdfConversion> conversion;  ///< Null: the raw numbers are the values.
  std::string unit;                                 ///< Of the conversion; empty: none stated.
};

/// The conversions of one file, each read once.
class MdfConversions {
 public:
  explicit MdfConversions(MdfBlocks& blocks) : blocks_(blocks) {}

  /// @param link of a ##CC; 0: no conversion.
  /// @throw UnreadChannel: a formula, texts that are converted, tables without order.
  /// @throw InputError as MdfBlocks::block().
  UnitConversion conversion(MdfLink link) { return conversion(link, 0); }

 private:
  UnitConversion conversion(MdfLink link, int depth);
  std::shared_ptr<const MdfConversion> read(const MdfBlock& block, int depth);
  std::shared_ptr<const MdfConversion> read_texts(const MdfBlock& block, std::size_t values_each,
                                                  int depth);

  MdfBlocks& blocks_;
  std::map<MdfLink, UnitConversion> known_;
};

}  // namespace tribolog::ingest::measurement
