// A log of 5 million rows and 4 columns: time, angle, speed and torque of a simulated sweep, as a
// logger prints them. Written once; read as the peer reads it (peer/read_csv.py): all four columns
// into memory. Prints seconds of the reading alone and the peak memory.
//   csv_bench write LOG.csv ROWS
//   csv_bench read LOG.csv

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <sys/resource.h>

#include "base/input_file.h"
#include "ingest/text/csv_reader.h"

using namespace tribolog;

namespace {

void write(const char* path, long rows) {
  std::ofstream out(path, std::ios::binary);
  out << "t_s,q_rad,dq_rad_s,tau_Nm\n";
  std::string block;
  for (long i = 0; i < rows; ++i) {
    const double t = 1e-3 * static_cast<double>(i);
    const double q = 1.2 * std::sin(0.01 * t);
    block += fmt::format("{:.6f},{:.9f},{:.9f},{:.6f}\n", t, q, 0.012 * std::cos(0.01 * t),
                         38.465 * std::cos(q) + 0.3 * std::sin(1e3 * t));
    if (block.size() < (1U << 20) && i + 1 < rows) continue;
    out << block;
    block.clear();
  }
}

int read(const char* path) {
  const auto begin = std::chrono::steady_clock::now();
  tribolog::InputFileSource bytes(path);
  const tribolog::ingest::text::CsvTable table =
      tribolog::ingest::text::read_csv(bytes, path, {{"t_s"}, {"q_rad"}, {"dq_rad_s"}, {"tau_Nm"}});
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  double sum = 0;
  for (const tribolog::ingest::log::LogColumn& column : table.columns) {
    for (const double value : column.values) sum += value;
  }
  std::printf("%.6f %zu %.17g %.1f %.1f\n", seconds, table.rows, sum,
              static_cast<double>(usage.ru_maxrss) / 1024,
              static_cast<double>(bytes.bytes_read()) / 1e6);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "write" && argc == 4) {
    write(argv[2], std::atol(argv[3]));
    return 0;
  }
  if (what == "read" && argc == 3) return read(argv[2]);
  std::fputs("csv_bench write LOG.csv ROWS | csv_bench read LOG.csv\n", stderr);
  return 2;
}
