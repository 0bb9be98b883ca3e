#pragma once
// Internal to the store: what an archive holds, to and from the rows of its tables.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "archive/sql/sql_connection.h"
#include "archive/store/calibration_archive.h"
#include "calibration/archived_calibration.h"

namespace tribolog::archive::store {

/// Of the table calibration, in the order of entry_of(): "number, id, ...".
extern const char* const entry_columns;
calibration::Entry entry_of(const sql::Row& row);
/// All but the number.
std::vector<sql::Value> values_of(const calibration::Entry& entry);

/// Of the table quantity: "name, words, ...".
extern const char* const quantity_columns;
/// @param first where the columns begin.
calibration::Quantity quantity_of(const sql::Row& row, std::size_t first = 0);

/// Of the tables input, review and document, each from the column behind the place or, of a
/// document, behind its calibration.
extern const char* const input_columns;
calibration::Input input_of(const sql::Row& row, std::size_t first = 0);
extern const char* const review_columns;
calibration::Review review_of(const sql::Row& row, std::size_t first = 0);
extern const char* const document_columns;
StoredDocument stored_document_of(const sql::Row& row, std::size_t first = 0);

std::string to_string(calibration::DocumentKind kind);

// Rows as the archive writes them. What is read back and makes another row was altered.
sql::Row row_of(const calibration::Quantity& quantity, std::int64_t calibration, std::size_t place);
sql::Row row_of(const calibration::Input& input, std::int64_t calibration, std::size_t place);
sql::Row row_of(const calibration::Review& review, std::int64_t calibration, std::size_t place);
sql::Row row_of(const StoredDocument& document, std::int64_t calibration);

/// What is kept beside a document's bytes. Their length in the archive is not known yet.
StoredDocument fingerprint_of(const calibration::Document& document);
std::vector<StoredDocument> fingerprints_of(const std::vector<calibration::Document>& documents);

// Which texts an archive takes.

/// @throw UsageError for a text that is not sql::is_kept_text().
void refuse_unkept_texts(const std::vector<sql::Value>& values);
void refuse_unkept_texts(const calibration::NewCalibration& calibration);

// Documents as they are stored: zstd frames.

std::string compressed(std::string_view bytes);

/// @param bytes how many they were.
/// @throw ArchiveError: damaged, or another length. @param name of the archive, for the message.
std::string uncompressed(const std::string& stored, std::uint64_t bytes, const std::string& name);

// One entry of an archive, held against its digest and its chain.

/// What the chain says of the entries that have to be there, by their ids.
struct ChainedEntries {
  std::map<std::string, std::string> digests;
  std::map<std::string, std::string> reports;               ///< Fingerprints.
  std::map<std::string, std::vector<std::string>> reviews;  ///< Digests in their order.
};

struct EntryProof {
  std::size_t documents{};
  std::vector<std::string> faults;  ///< Empty: the entry is as it was archived.
};

/// Every column of every row of the entry is covered: by its digest, by the chain, by a fingerprint
/// over what stands beside it, or since nothing else would have been written there.
/// @param version of the archive's schema.
EntryProof prove(sql::Connection& connection, int version, const calibration::Entry& entry,
                 const ChainedEntries& chain);

}  // namespace tribolog::archive::store
