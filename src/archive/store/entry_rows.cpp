#include "archive/store/entry_rows.h"

#include <optional>
#include <stdexcept>

#include <zstd.h>

#include "archive/sql/sql_connection.h"
#include "base/encodings.h"
#include "base/enum_text.h"
#include "base/error.h"

namespace tribolog::archive::store {

namespace {

calibration::Verdict verdict_of(const std::string& word) {
  using enum calibration::Verdict;
  return own_names<calibration::Verdict>.find(word).value_or(not_identifiable);
}

calibration::DocumentKind kind_of(const std::string& word) {
  using enum calibration::DocumentKind;
  return own_names<calibration::DocumentKind>.find(word).value_or(input);
}

std::int64_t whole(std::uint64_t number) { return static_cast<std::int64_t>(number); }

}  // namespace

const char* const entry_columns =
    "number, id, identity, revision, robot, serial, joint, measured_at, measured_on, "
    "time_is_stated, created_utc, operator, note, payload, payload_kg, payload_distance_m, "
    "temperature_C, gear_ratio, sampling_Hz, verdict, sentence, configuration, tool_version, "
    "git_revision, digest";

calibration::Entry entry_of(const sql::Row& row) {
  std::size_t at = 0;
  const auto text = [&]() -> const std::string& { return row[at++].text(); };
  const auto number = [&] { return row[at++].number_if_any(); };
  calibration::Entry e;
  calibration::Facts& f = e.facts;
  e.number = row[at++].integer();
  e.id = text();
  e.identity = text();
  e.revision = static_cast<int>(row[at++].integer());
  f.of.robot = text();
  f.of.serial = text();
  f.of.joint = text();
  f.measured_at = text();
  f.measured_on = text();
  f.time_is_stated = row[at++].integer() != 0;
  f.created_utc = text();
  f.operator_name = text();
  f.note = text();
  f.payload = text();
  f.payload_kg = number();
  f.payload_distance_m = number();
  f.temperature_C = number();
  f.gear_ratio = number().value_or(1);
  f.sampling_Hz = number();
  f.verdict = verdict_of(text());
  f.sentence = text();
  f.configuration = text();
  f.tool_version = text();
  f.git_revision = text();
  e.digest = text();
  return e;
}

std::vector<sql::Value> values_of(const calibration::Entry& e) {
  const calibration::Facts& f = e.facts;
  return {e.id,
          e.identity,
          std::int64_t{e.revision},
          f.of.robot,
          f.of.serial,
          f.of.joint,
          f.measured_at,
          f.measured_on,
          std::int64_t{f.time_is_stated ? 1 : 0},
          f.created_utc,
          f.operator_name,
          f.note,
          f.payload,
          f.payload_kg,
          f.payload_distance_m,
          f.temperature_C,
          f.gear_ratio,
          f.sampling_Hz,
          calibration::to_string(f.verdict),
          f.sentence,
          f.configuration,
          f.tool_version,
          f.git_revision,
          e.digest};
}

const char* const quantity_columns = "name, words, unit, quantity.verdict, value, low, high";

calibration::Quantity quantity_of(const sql::Row& row, std::size_t first) {
  calibration::Quantity q;
  q.name = row[first].text();
  q.words = row[first + 1].text();
  q.unit = row[first + 2].text();
  q.verdict = verdict_of(row[first + 3].text());
  const auto value = row[first + 4].number_if_any();
  if (value) {
    q.estimate = statistics::Estimate{*value,
                                      row[first + 5].number_if_any().value_or(*value),
                                      row[first + 6].number_if_any().value_or(*value),
                                      {}};
  }
  return q;
}

const char* const input_columns = "name, role, bytes, sha256";

calibration::Input input_of(const sql::Row& row, std::size_t first) {
  return {row[first].text(), row[first + 1].text(),
          static_cast<std::uint64_t>(row[first + 2].integer()), row[first + 3].text()};
}

const char* const review_columns = "at_utc, reviewer, decision, note";

calibration::Review review_of(const sql::Row& row, std::size_t first) {
  return {row[first].text(), row[first + 1].text(), calibration::decision_of(row[first + 2].text()),
          row[first + 3].text()};
}

const char* const document_columns = "kind, name, bytes, sha256, stored_bytes";

StoredDocument stored_document_of(const sql::Row& row, std::size_t first) {
  return {kind_of(row[first].text()), row[first + 1].text(),
          static_cast<std::uint64_t>(row[first + 2].integer()),
          static_cast<std::uint64_t>(row[first + 4].integer()), row[first + 3].text()};
}

std::string to_string(calibration::DocumentKind kind) { return own_name(kind); }

sql::Row row_of(const calibration::Quantity& q, std::int64_t calibration, std::size_t place) {
  std::optional<double> value;
  std::optional<double> low;
  std::optional<double> high;
  if (q.estimate) {
    value = q.estimate->value;
    low = q.estimate->low;
    high = q.estimate->high;
  }
  return {calibration, whole(place), q.name, q.words, q.unit, calibration::to_string(q.verdict),
          value,       low,          high};
}

sql::Row row_of(const calibration::Input& input, std::int64_t calibration, std::size_t place) {
  return {calibration, whole(place), input.name, input.role, whole(input.bytes), input.sha256};
}

sql::Row row_of(const calibration::Review& review, std::int64_t calibration, std::size_t place) {
  return {calibration,
          whole(place),
          review.at_utc,
          review.reviewer,
          std::string(calibration::to_string(review.decision)),
          review.note};
}

sql::Row row_of(const StoredDocument& document, std::int64_t calibration) {
  return {calibration,           to_string(document.kind), document.name,
          whole(document.bytes), document.sha256,          whole(document.stored_bytes)};
}

StoredDocument fingerprint_of(const calibration::Document& document) {
  return {document.kind, document.name, document.bytes.size(), 0, sha256_hex(document.bytes)};
}

std::vector<StoredDocument> fingerprints_of(const std::vector<calibration::Document>& documents) {
  std::vector<StoredDocument> fingerprints;
  for (const calibration::Document& document : documents)
    fingerprints.push_back(fingerprint_of(document));
  return fingerprints;
}

namespace {

void refuse_unkept(const std::string& text) {
  if (!sql::is_kept_text(text)) {
    throw UsageError("an archive keeps texts in UTF-8, without the character NUL: '" +
                     printable(text) + "' is none");
  }
}

}  // namespace

void refuse_unkept_texts(const std::vector<sql::Value>& values) {
  for (const sql::Value& value : values) {
    if (const auto* text = std::get_if<std::string>(&value.content())) refuse_unkept(*text);
  }
}

void refuse_unkept_texts(const calibration::NewCalibration& calibration) {
  calibration::Entry entry;
  entry.facts = calibration.facts;
  refuse_unkept_texts(values_of(entry));
  for (const calibration::Quantity& q : calibration.quantities) {
    for (const std::string* text : {&q.name, &q.words, &q.unit}) refuse_unkept(*text);
  }
  for (const calibration::Input& input : calibration.inputs) {
    for (const std::string* text : {&input.name, &input.role}) refuse_unkept(*text);
  }
  for (const calibration::Document& document : calibration.documents) refuse_unkept(document.name);
}

namespace {

/// Dense where that costs little; a report is mostly pictures, which no effort makes much smaller.
int level_for(std::size_t bytes) {
  constexpr std::size_t few_bytes = std::size_t{1} << 19;
  return bytes <= few_bytes ? 19 : 9;
}

[[noreturn]] void refuse(const std::string& name) {
  throw ArchiveError(printable(name, longest_path) +
                     ": a document in the archive is damaged; restore a backup");
}

}  // namespace

std::string compressed(std::string_view bytes) {
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t written =
      ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), level_for(bytes.size()));
  if (ZSTD_isError(written) != 0) {
    throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(written));
  }
  out.resize(written);
  return out;
}

std::string uncompressed(const std::string& stored, std::uint64_t bytes, const std::string& name) {
  // The length comes from the archive and may be damaged: only what the frame states is made room
  // for, and no more than a frame of this size can hold.
  constexpr std::uint64_t smallest_block = 4;
  if (ZSTD_getFrameContentSize(stored.data(), stored.size()) != bytes) refuse(name);
  if (bytes / ZSTD_BLOCKSIZE_MAX > stored.size() / smallest_block) refuse(name);
  std::string out(bytes, '\0');
  const std::size_t read = ZSTD_decompress(out.data(), out.size(), stored.data(), stored.size());
  if (ZSTD_isError(read) != 0 || read != bytes) refuse(name);
  return out;
}

}  // namespace tribolog::archive::store
