// Flips single bits of an archive: each is noticed by verify, or every content is as before, and
// nothing but one clear error ever comes out.
//
//   archive_bit_flips COUNT [SEED]

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <random>

#include <fmt/format.h>

#include "archive/sample_calibration.h"
#include "archive/store/archive_json.h"
#include "archive/store/archive_location.h"
#include "base/error.h"
#include "base/input_file.h"
#include "base/temporary_directory.h"

namespace tribolog::archive {
namespace {

const std::string now = "2026-12-24T12:00:00Z";

/// Text that compresses little, as a report's pictures.
std::string noise(int lines) {
  std::string text;
  for (int k = 0; k < lines; ++k) text += sha256_hex(std::to_string(k)) + "\n";
  return text;
}

void fill(const std::string& path) {
  store::CalibrationArchive archive = store::open_archive(path, sql::Access::write);
  for (int day = 0; day < 4; ++day) {
    calibration::NewCalibration c = test::sample_calibration(1, 1 + day % 2, day, 0.4 + 0.01 * day);
    c.facts.note = "note of day " + std::to_string(day);
    c.documents.front().bytes += noise(100);
    if (day == 1) {
      for (const calibration::Input& input : c.inputs) {
        c.documents.push_back(
            {calibration::DocumentKind::input, input.name, noise(50) + input.name});
      }
    }
    const std::string id = archive.add(c, false, now).id;
    if (day > 1) archive.attach_report(id, "<html>" + noise(600) + std::to_string(day), now);
    archive.add_review(archive.find(id),
                       {now, "A. Nowak", calibration::Review::Decision::approved, "good"});
  }
  archive.remove(archive.list({}).front(), now);
}

/// Everything that the commands show or give back.
std::string contents(const std::string& path) {
  store::CalibrationArchive archive = store::open_archive(path, sql::Access::read);
  const std::vector<calibration::Entry> entries = archive.list({});
  std::string all = store::entries_json(entries, archive.decisions({}));
  for (const calibration::Entry& entry : entries) {
    const auto documents = archive.documents(entry);
    all += store::entry_json(entry, archive.quantities(entry), archive.inputs(entry), documents,
                             archive.reviews(entry));
    for (const store::StoredDocument& document : documents) {
      all += archive.document(entry, document.kind, document.name).value_or("nothing");
    }
  }
  return all;
}

struct Counts {
  std::size_t refused{};    ///< When it is opened or read.
  std::size_t found{};      ///< By verify.
  std::size_t identical{};  ///< Nothing that is shown has changed.
};

/// @return what is wrong; empty: nothing.
std::string check_flip(const std::string& path, const std::string& before, Counts& counts) {
  bool is_noticed = true;
  try {
    const auto faults = store::open_archive(path, sql::Access::read).verify("", {}).faults;
    is_noticed = !faults.empty();
    if (is_noticed) ++counts.found;
  } catch (const Error& error) {
    if (error.status() != ExitStatus::archive_failed) {
      return fmt::format("verify: status {}: {}", static_cast<int>(error.status()), error.what());
    }
    ++counts.refused;
  }
  try {
    if (contents(path) == before) {
      if (!is_noticed) ++counts.identical;
    } else if (!is_noticed) {
      return "other contents, unnoticed";
    }
  } catch (const ArchiveError& error) {
    if (!is_noticed) return std::string("unnoticed, but: ") + error.what();
  }
  try {
    store::open_archive(path, sql::Access::write)
        .add(test::sample_calibration(2, 1, 1, 0.5), false, now);
  } catch (const Error& error) {
    if (error.status() != ExitStatus::archive_failed &&
        error.status() != ExitStatus::output_failed) {
      return fmt::format("add: status {}: {}", static_cast<int>(error.status()), error.what());
    }
  }
  return "";
}

int run(std::size_t count, unsigned seed) {
  const test::TemporaryDirectory directory;
  const std::string original = directory.path("a.tribolog");
  fill(original);
  const std::string bytes = read_file(original);
  const std::string before = contents(original);
  std::mt19937_64 random(seed);
  Counts counts;
  std::size_t wrong = 0;
  for (std::size_t k = 0; k < count; ++k) {
    // One in ten in the file's header and the schema, of which there is little.
    const std::size_t range =
        k % 10 == 0 ? std::min<std::size_t>(bytes.size(), 4096) : bytes.size();
    const std::size_t byte = random() % range;
    const auto bit = static_cast<unsigned>(random() % 8);
    std::string flipped = bytes;
    flipped[byte] = static_cast<char>(static_cast<unsigned char>(flipped[byte]) ^ (1U << bit));
    const test::TemporaryDirectory place;
    const std::string path = place.file("a.tribolog", flipped);
    std::string fault;
    try {
      fault = check_flip(path, before, counts);
    } catch (const std::exception& error) {
      fault = std::string("a fault of the program: ") + error.what();
    }
    if (fault.empty()) continue;
    ++wrong;
    std::cout << fmt::format("byte {} bit {}: {}\n", byte, bit, fault);
  }
  std::cout << fmt::format(
      "{} flips in {} bytes: {} refused, {} found by verify, {} without effect, {} wrong\n", count,
      bytes.size(), counts.refused, counts.found, counts.identical, wrong);
  return wrong == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tribolog::archive

int main(int argc, char** argv) {
  const std::size_t count = argc > 1 ? std::stoul(argv[1]) : 400;
  const unsigned seed = argc > 2 ? static_cast<unsigned>(std::stoul(argv[2])) : 1;
  return tribolog::archive::run(count, seed);
}
