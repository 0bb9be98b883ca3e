#include <set>

#include <gtest/gtest.h>

#include "render/layout/axis.h"

namespace tribolog::render::date_ticks_test {
namespace {

constexpr double new_year_2026 =
    20454;  // days since 1970-01-01, as `date -d 2026-01-01 +%s` / 86400

std::vector<std::string> labels(const layout::AxisRange& range, int most) {
  std::vector<std::string> out;
  for (const layout::Tick& tick : layout::date_ticks(range, most).major) out.push_back(tick.label);
  return out;
}

TEST(DateTicks, AreTheBeginningsOfYearsMonthsDaysAndHours) {
  EXPECT_EQ(labels({new_year_2026 - 400, new_year_2026 + 800}, 6),
            (std::vector<std::string>{"2025", "2026", "2027", "2028"}));
  EXPECT_EQ(labels({new_year_2026 - 3, new_year_2026 + 100}, 6),
            (std::vector<std::string>{"2026-01", "2026-02", "2026-03", "2026-04"}));
  EXPECT_EQ(labels({new_year_2026 + 56.5, new_year_2026 + 61.5}, 6),
            (std::vector<std::string>{"2026-02-27", "2026-02-28", "2026-03-01", "2026-03-02",
                                      "2026-03-03"}))
      << "2026 is no leap year";
  EXPECT_EQ(labels({new_year_2026 + 0.2, new_year_2026 + 0.8}, 4),
            (std::vector<std::string>{"2026-01-01 06:00", "2026-01-01 12:00", "2026-01-01 18:00"}));
}

TEST(DateTicks, LieInsideTheRangeAndAreFewAndDistinctAtEveryScale) {
  for (double span = 0.1; span < 2e6; span *= 1.7) {
    for (double low = -200000; low < 800000; low += 33333.3) {
      const layout::AxisRange range{low, low + span};
      for (const int most : {2, 5, 12}) {
        const layout::TickSet ticks = layout::date_ticks(range, most);
        EXPECT_LE(static_cast<int>(ticks.major.size()), most) << low << " " << span;
        EXPECT_GE(ticks.major.size(), 1U) << low << " " << span << " " << most;
        std::set<std::string> seen;
        for (const layout::Tick& tick : ticks.major) {
          EXPECT_GE(tick.value, range.low);
          EXPECT_LE(tick.value, range.high);
          EXPECT_TRUE(seen.insert(tick.label).second) << tick.label;
        }
      }
    }
  }
}

TEST(DateTicks, BeyondTheCalendarAreNumbers) {
  EXPECT_EQ(labels({-1e9, 1e9}, 5), (std::vector<std::string>{"−1.0", "−0.5", "0", "0.5", "1.0"}));
  EXPECT_FALSE(layout::date_ticks({0, 1e-6}, 5).major.empty());
}

}  // namespace
}  // namespace tribolog::render::date_ticks_test
