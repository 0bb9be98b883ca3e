
#include <fmt/format.h>

#include "archive/store/digest.h"
#include "archive/store/entry_rows.h"
#include "archive/store/schema.h"
#include "base/encodings.h"
#include "base/error.h"

namespace tribolog::archive::store {
namespace {

using sql::Row;
using sql::Rows;

class Prover {
 public:
  Prover(sql::Connection& connection, int version, const calibration::Entry& entry,
         const ChainedEntries& chain)
      : connection_(connection), version_(version), entry_(entry), chain_(chain) {}

  EntryProof prove() {
    const auto quantities = read<calibration::Quantity>(
        "quantity", "name, words, unit, verdict, value, low, high",
        [](const Row& row) { return quantity_of(row, 2); }, "quantities");
    const auto inputs = read<calibration::Input>(
        "input", input_columns, [](const Row& row) { return input_of(row, 2); }, "inputs");
    check_facts(inputs);
    const std::vector<StoredDocument> documents = checked_documents();
    check_digest(quantities, inputs, documents);
    if (version_ >= first_schema_with_reviews) check_reviews();
    return std::move(proof_);
  }

 private:
  void fault(const std::string& what) { proof_.faults.push_back(what); }

  /// The rows of a table, which have to be those that tribolog writes for what they say.
  template <class Part, class Read>
  std::vector<Part> read(const char* table, const char* columns, const Read& part_of,
                         const char* what) {
    std::vector<Part> parts;
    bool is_ours = true;
    for (const Row& row :
         connection_.run(fmt::format("SELECT calibration, place, {} FROM {} WHERE calibration = $1 "
                                     "ORDER BY place",
                                     columns, table),
                         {entry_.number})) {
      parts.push_back(part_of(row));
      is_ours = is_ours && row == row_of(parts.back(), entry_.number, parts.size() - 1);
    }
    if (!is_ours) fault(fmt::format("its {} are not as tribolog writes them", what));
    return parts;
  }

  void check_facts(const std::vector<calibration::Input>& inputs) {
    const Rows rows =
        connection_.run(fmt::format("SELECT {} FROM calibration WHERE number = $1", entry_columns),
                        {entry_.number});
    Row expected{entry_.number};
    for (sql::Value& value : values_of(entry_)) expected.push_back(std::move(value));
    if (rows.size() != 1 || rows.front() != expected) fault("is not as tribolog writes it");
    if (identity_of(inputs) != entry_.identity) fault("its identity is not that of its inputs");
    if (id_of(entry_.identity, entry_.revision) != entry_.id) {
      fault("its id is not that of its identity and revision");
    }
  }

  /// The calibration comes first, the report last, and inputs stand between.
  std::vector<StoredDocument> checked_documents() {
    std::vector<StoredDocument> documents;
    for (const Row& row : connection_.run(
             fmt::format(
                 "SELECT calibration, {}, number, (SELECT CAST(length(zstd) AS BIGINT) FROM "
                 "content WHERE content.document = document.number) FROM document WHERE "
                 "calibration = $1 ORDER BY number",
                 document_columns),
             {entry_.number})) {
      ++proof_.documents;
      documents.push_back(stored_document_of(row, 1));
      check_document(row, documents);
    }
    if (documents.empty()) fault("its calibration is missing");
    const bool has_report =
        !documents.empty() && documents.back().kind == calibration::DocumentKind::report;
    if (!has_report && chain_.reports.count(entry_.id) > 0) fault("its report is missing");
    return documents;
  }

  void check_document(const Row& row, const std::vector<StoredDocument>& up_to_this) {
    const StoredDocument& stored = up_to_this.back();
    const bool is_first = up_to_this.size() == 1;
    const std::string what = to_string(stored.kind);
    Row expected = row_of(stored, entry_.number);
    expected.push_back(row[expected.size()]);  // the number, which the order shows
    expected.emplace_back(static_cast<std::int64_t>(stored.stored_bytes));
    const bool has_name = stored.kind == calibration::DocumentKind::input;
    if (row.back().is_null()) return fault("its " + what + " is missing");
    if (row != expected || (!has_name && !stored.name.empty())) {
      fault("its " + what + " is not kept as tribolog keeps it");
    }
    if (is_first != (stored.kind == calibration::DocumentKind::calibration)) {
      fault("its documents are not in the order in which they were kept");
    }
    if (!is_first && up_to_this[up_to_this.size() - 2].kind == calibration::DocumentKind::report) {
      fault("it has a document behind its report");
    }
    if (stored.kind == calibration::DocumentKind::report) {
      const auto report = chain_.reports.find(entry_.id);
      if (report == chain_.reports.end() || report->second != stored.sha256) {
        fault("its report is not the one that was archived");
      }
    }
    if (!is_whole(stored, row[row.size() - 2])) fault("its " + what + " is damaged");
  }

  [[nodiscard]] bool is_whole(const StoredDocument& stored, const sql::Value& number) const {
    try {
      const Rows rows = connection_.run("SELECT zstd FROM content WHERE document = $1", {number});
      return rows.size() == 1 && sha256_hex(uncompressed(rows.front().front().bytes(), stored.bytes,
                                                         connection_.name())) == stored.sha256;
    } catch (const ArchiveError&) {
      return false;
    }
  }

  void check_digest(const std::vector<calibration::Quantity>& quantities,
                    const std::vector<calibration::Input>& inputs,
                    const std::vector<StoredDocument>& documents) {
    const auto known = chain_.digests.find(entry_.id);
    if (known == chain_.digests.end()) {
      fault("stands in no event: it was not added by tribolog");
    } else if (known->second != entry_.digest) {
      fault("its digest is not the one it was added with");
    }
    if (digest_of(entry_.id, entry_.facts, quantities, inputs, documents) == entry_.digest) {
      if (version_ < first_schema_with_wide_digests) fault("is newer than the archive's schema");
    } else if (narrow_digest_of(entry_.id, entry_.facts, quantities, inputs, documents) ==
               entry_.digest) {
      check_kept_inputs(inputs, documents);
    } else {
      fault("was altered: its digest is not that of what it says");
    }
  }

  /// Where the digest does not say which inputs were kept: all or none.
  void check_kept_inputs(const std::vector<calibration::Input>& inputs,
                         const std::vector<StoredDocument>& documents) {
    std::vector<StoredDocument> kept;
    for (const StoredDocument& document : documents) {
      if (document.kind == calibration::DocumentKind::input) kept.push_back(document);
    }
    bool are_those = kept.empty() || kept.size() == inputs.size();
    for (std::size_t k = 0; are_those && k < kept.size(); ++k) {
      are_those = kept[k].name == inputs[k].name && kept[k].sha256 == inputs[k].sha256;
    }
    if (!are_those) fault("the inputs kept with it are not those it was made from");
  }

  void check_reviews() {
    const auto reviews = read<calibration::Review>(
        "review", review_columns, [](const Row& row) { return review_of(row, 2); }, "reviews");
    std::vector<std::string> digests;
    for (const calibration::Review& review : reviews) {
      digests.push_back(digest_of(entry_.id, digests.size(), review));
    }
    const auto given = chain_.reviews.find(entry_.id);
    const bool are_those =
        given == chain_.reviews.end() ? digests.empty() : given->second == digests;
    if (!are_those) fault("its reviews are not those that were given");
  }

  sql::Connection& connection_;
  int version_;
  const calibration::Entry& entry_;
  const ChainedEntries& chain_;
  EntryProof proof_;
};

}  // namespace

EntryProof prove(sql::Connection& connection, int version, const calibration::Entry& entry,
                 const ChainedEntries& chain) {
  return Prover(connection, version, entry, chain).prove();
}

}  // namespace tribolog::archive::store
