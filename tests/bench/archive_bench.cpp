// An archive of many calibrations: bytes for each, and how long the questions take that a user asks
// every day.
//   archive_bench FILE [CALIBRATIONS=100000] [DOCUMENT_BYTES=39000]
// 500 robots of 6 joints. Each document is noise of the size that a calibration has when it is
// compressed (210 kB to 39 kB, the paper's joint with noise). A file that is there is not filled
// again.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "archive/sample_calibration.h"
#include "archive/sql/databases.h"
#include "archive/store/calibration_archive.h"
#include "archive/store/schema.h"
#include "statistics/random_stream.h"

namespace {

using namespace tribolog;
using Clock = std::chrono::steady_clock;

constexpr int robots = 500;
constexpr int joints = 6;
const std::string now = "2026-12-24T12:00:00Z";

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

tribolog::archive::store::CalibrationArchive opened(const std::string& path,
                                                    tribolog::archive::sql::Access access) {
  return tribolog::archive::store::CalibrationArchive(
      tribolog::archive::sql::open_sqlite(path, access, tribolog::archive::sql::usual_wait_ms));
}

/// Without waiting for the disk each time: filling is not what is measured.
void fill(const std::string& path, int count, std::size_t document_bytes) {
  tribolog::archive::sql::create_sqlite(path, [](tribolog::archive::sql::Connection& c) {
    tribolog::archive::store::create_schema(c);
  });
  auto connection = tribolog::archive::sql::open_sqlite(path, tribolog::archive::sql::Access::write,
                                                        tribolog::archive::sql::usual_wait_ms);
  connection->run_script("PRAGMA synchronous=OFF");
  tribolog::archive::store::CalibrationArchive archive(std::move(connection));
  tribolog::statistics::RandomStream random(1, 0);
  for (int k = 0; k < count; ++k) {
    const double coulomb_Nm = 0.45 * (1 + 0.01 * (random.uniform() - 0.5));
    auto c = tribolog::test::sample_calibration(k % robots, k / robots % joints,
                                                k / (robots * joints), coulomb_Nm);
    const tribolog::calibration::Quantity first = c.quantities.front();
    for (int q = 0; q < 9; ++q) {
      tribolog::calibration::Quantity other = first;
      other.name = fmt::format("quantity_{}", q);
      c.quantities.push_back(other);
    }
    for (int i = 0; i < 22; ++i) {
      c.inputs.push_back({fmt::format("constant_speed_{:02}.csv", i), "constant_speed", 561407,
                          tribolog::sha256_hex(fmt::format("{} {}", k, i))});
    }
    std::string& bytes = c.documents.front().bytes;
    while (bytes.size() < document_bytes) {
      bytes += static_cast<char>(random.uniform() * 256);
    }
    archive.add(c, false, now);
    if (k % 10000 == 9999) std::printf("  %d archived\n", k + 1);
  }
}

template <class Question>
void time(const char* what, const Question& question) {
  std::vector<double> times_ms;
  std::size_t found = 0;
  for (int round = 0; round < 9; ++round) {
    const auto start = Clock::now();
    found = question(round);
    times_ms.push_back(ms_since(start));
  }
  std::sort(times_ms.begin(), times_ms.end());
  std::printf("%-40s %8.2f ms (%.2f to %.2f), %zu found\n", what, times_ms[times_ms.size() / 2],
              times_ms.front(), times_ms.back(), found);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const std::string path = argv[1];
  const int count = argc > 2 ? std::atoi(argv[2]) : 100'000;
  const auto document_bytes = static_cast<std::size_t>(argc > 3 ? std::atoi(argv[3]) : 39'000);
  if (!std::filesystem::exists(path)) fill(path, count, document_bytes);
  std::printf("%.1f kB for each of %d calibrations\n",
              1e-3 * static_cast<double>(std::filesystem::file_size(path)) / count, count);
  time("open, list one robot", [&](int round) {
    tribolog::archive::store::Filter filter;
    filter.robot = fmt::format("R{}", 7 * round);
    return opened(path, tribolog::archive::sql::Access::read).list(filter).size();
  });
  time("open, results of one joint over time", [&](int round) {
    tribolog::archive::store::Filter filter;
    filter.robot = fmt::format("R{}", 3 * round);
    filter.serial = fmt::format("S{}", 3 * round);
    filter.joint = "J2";
    filter.latest_revisions = true;
    return opened(path, tribolog::archive::sql::Access::read).measured(filter).size();
  });
  time("list all",
       [&](int) { return opened(path, tribolog::archive::sql::Access::read).list({}).size(); });
  time("archive one more", [&](int round) {
    auto c = tribolog::test::sample_calibration(-1, 0, round, 0.45);
    c.inputs.front().sha256 =
        tribolog::sha256_hex(fmt::format("{}", Clock::now().time_since_epoch().count()));
    return opened(path, tribolog::archive::sql::Access::write).add(c, false, now).id.size() / 64;
  });
  return 0;
}
