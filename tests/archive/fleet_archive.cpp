// An archive of a whole fleet, to look at the fleet sheet of and to measure it:
//   fleet_archive ARCHIVE [ROBOTS JOINTS CALIBRATIONS]

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "archive/store/archive_location.h"
#include "history/sample_fleet.h"

int main(int argc, char** argv) {
  using namespace tribolog;
  if (argc != 2 && argc != 5) {
    std::fputs("usage: fleet_archive ARCHIVE [ROBOTS JOINTS CALIBRATIONS]\n", stderr);
    return 2;
  }
  tribolog::test::FleetSize size{500, 6, 10};
  if (argc == 5) size = {std::atoi(argv[2]), std::atoi(argv[3]), std::atoi(argv[4])};
  try {
    tribolog::archive::store::CalibrationArchive kept =
        tribolog::archive::store::open_archive(argv[1], tribolog::archive::sql::Access::write);
    int number = 0;
    tribolog::test::sample_fleet(size, 1, [&](tribolog::calibration::NewCalibration c) {
      // Some joints as they are not to be: twenty wear out in the end, ten are of another kind.
      const bool is_last = (number + 1) % size.calibrations == 0;
      const int joint = number++ / size.calibrations;
      const auto scale = [&](std::size_t quantity, double factor) {
        tribolog::statistics::Estimate& e = *c.quantities[quantity].estimate;
        e = tribolog::statistics::scaled(e, factor);
      };
      if (joint % 150 == 7 && is_last) scale(7, 1.3);
      if (joint % 300 == 11) scale(9, 1.5);
      kept.add(c, false, "2026-12-24T12:00:00Z");
    });
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
