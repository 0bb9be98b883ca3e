// libFuzzer: whatever a text log holds, it is read or refused in one clear line, and comes out the
// same whether it arrives at once or in pieces.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/input_file.h"
#include "fuzz/check_tables.h"
#include "fuzz/outcomes.h"
#include "ingest/text/csv_reader.h"

namespace {

using namespace tribolog;

/// Pieces of a few bytes, of one length after the other.
class PieceSource final : public ByteSource {
 public:
  explicit PieceSource(std::string_view bytes) : rest_(bytes), all_(bytes.size()) {}
  std::size_t read(char* to, std::size_t most) override {
    const std::size_t bytes = std::min({most, rest_.size(), 1 + ++pieces_ % 7});
    std::memcpy(to, rest_.data(), bytes);
    rest_.remove_prefix(bytes);
    return bytes;
  }
  [[nodiscard]] std::uint64_t likely_bytes() const override { return all_; }

 private:
  std::string_view rest_;
  std::uint64_t all_;
  std::size_t pieces_{0};
};

struct Outcome {
  std::optional<ingest::text::CsvTable> table;
  std::string refusal;
};

Outcome read(ByteSource& source, const ingest::text::TextLogRules& rules) {
  Outcome outcome;
  try {
    outcome.table = ingest::text::read_csv(source, "fuzz.csv", {}, rules);
  } catch (const InputError& refused) {
    outcome.refusal = refused.what();
  }
  return outcome;
}

bool same(const ingest::log::LogColumn& a, const ingest::log::LogColumn& b) {
  return a.gaps == b.gaps && a.origin == b.origin && a.values.size() == b.values.size() &&
         std::equal(a.values.begin(), a.values.end(), b.values.begin(),
                    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  ingest::text::TextLogRules rules;
  if ((data[0] & 1U) != 0) rules.decimal_mark = ingest::text::DecimalMark::comma;
  if ((data[0] & 2U) != 0) rules.delimiter = ingest::text::Delimiter::semicolon;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  MemorySource whole(bytes);
  PieceSource pieces(bytes);
  const Outcome one = read(whole, rules);
  const Outcome other = read(pieces, rules);
  fuzz::require(one.refusal == other.refusal);
  fuzz::count_outcome(one.table.has_value());
  if (!one.table) return 0;
  fuzz::require(one.table->columns.size() == other.table->columns.size());
  for (std::size_t k = 0; k < one.table->columns.size(); ++k) {
    fuzz::require(same(one.table->columns[k], other.table->columns[k]));
  }
  if (one.table->columns.empty()) return 0;
  fuzz::check_columns(*one.table);
  return 0;
}
