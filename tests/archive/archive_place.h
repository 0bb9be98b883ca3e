#pragma once
// Where a test keeps an archive: what holds of one holds of the other.

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "archive/archive_location.h"

namespace tribolog::test {

/// An archive of its own for each test; not made yet.
class ArchivePlace {
 public:
  virtual ~ArchivePlace() = default;
  /// As after --archive.
  [[nodiscard]] virtual std::string location() const = 0;
  /// Statements as another program would run them. Rows that belong to others go with those
  /// (ON DELETE CASCADE) only where `cascades`.
  virtual void run(const std::string& statements, bool cascades) = 0;
  /// An archive that is not made yet again.
  virtual void start_again() = 0;
};

/// Makes a place. @return nothing where there can be none; `why` says it.
using MakePlace = std::unique_ptr<ArchivePlace> (*)(std::string& why);

class AnyArchive : public testing::TestWithParam<MakePlace> {
 protected:
  void SetUp() override {
    std::string why;
    place_ = GetParam()(why);
    if (!place_) GTEST_SKIP() << why;
  }
  [[nodiscard]] archive::CalibrationArchive open(sql::Access access = sql::Access::write) const {
    return archive::open_archive(place_->location(), access, 200);
  }
  [[nodiscard]] std::vector<std::string> faults(const std::string& head = "") const {
    return open(sql::Access::read).verify(head, {}).faults;
  }
  std::unique_ptr<ArchivePlace> place_;
};

}  // namespace tribolog::test
