#pragma once
// Calibrations, kept: each one transaction, each with a digest, each addition and removal a link
// of a chain, so that a loss or an alteration is found.
//
// What add() has returned is on the disk, whatever happens to the program or the machine.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "archive/sql/sql_connection.h"
#include "calibration/archived_calibration.h"

namespace tribolog::archive::store {

/// Which entries; what is absent excludes none.
struct Filter {
  std::optional<std::string> robot;
  std::optional<std::string> serial;
  std::optional<std::string> joint;
  bool latest_revisions{false};  ///< Of what was archived several times the last one alone.
};

struct Added {
  std::string id;
  bool is_new{};             ///< false: the same inputs are archived already, under this id.
  std::string tool_version;  ///< By which what is there was made.
};

/// A document's place and fingerprint, without its bytes.
struct StoredDocument {
  calibration::DocumentKind kind{};
  std::string name;
  std::uint64_t bytes{};
  std::uint64_t stored_bytes{};
  std::string sha256;
};

struct Verification {
  std::size_t entries{};
  std::size_t documents{};
  std::size_t events{};
  std::string head;                 ///< The chain's last link: names this state of the archive.
  bool contains_head{true};         ///< The link that was asked for is one of the chain.
  std::vector<std::string> faults;  ///< Empty: all is as it was archived.
};

class CalibrationArchive {
 public:
  /// @throw ArchiveError: the schema is newer than the program, or there is none.
  explicit CalibrationArchive(std::unique_ptr<sql::Connection> connection);

  /// @param again archives it as a new revision where the same inputs are archived already.
  /// @param now_utc for the chain.
  Added add(const calibration::NewCalibration& calibration, bool again, const std::string& now_utc);

  /// All of them in one transaction: those of a robot's joints, none of which is there without the
  /// others. In their order.
  std::vector<Added> add(const std::vector<calibration::NewCalibration>& calibrations, bool again,
                         const std::string& now_utc);

  /// The report that was made of an entry. @return false: it has one already, which stays.
  bool attach_report(const std::string& id, std::string_view html, const std::string& now_utc);

  /// By robot, serial, joint, time and revision, in the order of the texts' bytes.
  std::vector<calibration::Entry> list(const Filter& filter);

  /// @param digits the first of an id; at least four.
  /// @throw UsageError: none has them, or several do.
  calibration::Entry find(const std::string& digits);

  std::vector<calibration::Quantity> quantities(const calibration::Entry& entry);
  std::vector<calibration::Input> inputs(const calibration::Entry& entry);
  std::vector<StoredDocument> documents(const calibration::Entry& entry);

  /// The filtered entries with their results, in the order of list(), of one state of the archive.
  std::vector<calibration::Measured> measured(const Filter& filter);

  /// Its bytes as they were. @return nothing where it has none.
  /// @throw ArchiveError: they are not what was archived.
  std::optional<std::string> document(const calibration::Entry& entry,
                                      calibration::DocumentKind kind, const std::string& name = "");

  /// Kept behind those that are there, with a link of the chain at its own time.
  /// @throw UsageError: a text that no archive keeps.
  void add_review(const calibration::Entry& entry, const calibration::Review& review);

  /// In the order in which they were given.
  std::vector<calibration::Review> reviews(const calibration::Entry& entry);

  /// On the filtered entries, in one query.
  calibration::Decisions decisions(const Filter& filter);

  /// The entry whose report, as it was archived, has this fingerprint.
  std::optional<calibration::Entry> find_report(const std::string& sha256);

  void remove(const calibration::Entry& entry, const std::string& now_utc);

  /// Reads everything. @param head a link that the chain has to have; empty: none.
  Verification verify(const std::string& head,
                      const std::function<void(std::size_t, std::size_t)>& progress);

  /// SQLite alone: a copy in a file that does not exist yet.
  /// @throw UsageError for a PostgreSQL archive.
  void backup(const std::string& path);

  [[nodiscard]] const std::string& name() const { return connection_->name(); }

 private:
  void append_event(const char* what, const std::string& id, const std::string& digest,
                    const std::string& now_utc);
  /// Within a transaction.
  Added insert(const calibration::NewCalibration& calibration, bool again,
               const std::string& now_utc);
  void add_document(std::int64_t calibration, const calibration::Document& document);

  std::unique_ptr<sql::Connection> connection_;
};

}  // namespace tribolog::archive::store
