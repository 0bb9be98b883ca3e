#include "archive/store/digest.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "base/encodings.h"

namespace tribolog::archive::store {
namespace {

class Fields {
 public:
  explicit Fields(const char* kind) { add(std::string(kind)); }

  void add(const std::string& text) { hash_.add(fmt::format("{}:{};", text.size(), text)); }
  void add(std::uint64_t number) { hash_.add(fmt::format("#{};", number)); }
  /// SQLite keeps -0 as 0.
  void add(double number) { add(std::bit_cast<std::uint64_t>(number == 0 ? 0.0 : number)); }
  void add(const std::optional<double>& number) {
    if (number) {
      add(*number);
    } else {
      hash_.add("-;");
    }
  }
  [[nodiscard]] std::string hex() { return hash_.hex(); }

 private:
  Sha256 hash_;
};

void add_facts(Fields& fields, const std::string& id, const calibration::Facts& f,
               const std::string& calibration_sha256) {
  for (const std::string* text :
       {&id, &f.of.robot, &f.of.serial, &f.of.joint, &f.measured_at, &f.measured_on, &f.created_utc,
        &f.operator_name, &f.note, &f.payload, &f.sentence, &f.configuration, &f.tool_version,
        &f.git_revision, &calibration_sha256}) {
    fields.add(*text);
  }
  fields.add(std::uint64_t{f.time_is_stated ? 1U : 0U});
  fields.add(calibration::to_string(f.verdict));
  for (const auto& number : {f.payload_kg, f.payload_distance_m, f.temperature_C, f.sampling_Hz}) {
    fields.add(number);
  }
  fields.add(f.gear_ratio);
}

void add_quantities(Fields& fields, const std::vector<calibration::Quantity>& quantities) {
  for (const calibration::Quantity& q : quantities) {
    for (const std::string& text : {q.name, q.words, q.unit, calibration::to_string(q.verdict)}) {
      fields.add(text);
    }
    fields.add(q.estimate ? std::optional(q.estimate->value) : std::nullopt);
    fields.add(q.estimate ? std::optional(q.estimate->low) : std::nullopt);
    fields.add(q.estimate ? std::optional(q.estimate->high) : std::nullopt);
  }
}

void add_inputs(Fields& fields, const std::vector<calibration::Input>& inputs) {
  for (const calibration::Input& input : inputs) {
    for (const std::string& text : {input.name, input.role, input.sha256}) fields.add(text);
    fields.add(input.bytes);
  }
}

std::string calibration_sha256(const std::vector<StoredDocument>& documents) {
  const auto at =
      std::find_if(documents.begin(), documents.end(), [](const StoredDocument& document) {
        return document.kind == calibration::DocumentKind::calibration;
      });
  return at == documents.end() ? "" : at->sha256;
}

}  // namespace

std::string digest_of(const std::string& id, const calibration::Facts& facts,
                      const std::vector<calibration::Quantity>& quantities,
                      const std::vector<calibration::Input>& inputs,
                      const std::vector<StoredDocument>& kept) {
  Fields fields("tribolog-entry-2");
  add_facts(fields, id, facts, calibration_sha256(kept));
  fields.add(std::uint64_t{quantities.size()});
  add_quantities(fields, quantities);
  fields.add(std::uint64_t{inputs.size()});
  add_inputs(fields, inputs);
  for (const StoredDocument& document : kept) {
    if (document.kind != calibration::DocumentKind::input) continue;
    for (const std::string& text : {document.name, document.sha256}) fields.add(text);
    fields.add(document.bytes);
  }
  return fields.hex();
}

std::string narrow_digest_of(const std::string& id, const calibration::Facts& facts,
                             const std::vector<calibration::Quantity>& quantities,
                             const std::vector<calibration::Input>& inputs,
                             const std::vector<StoredDocument>& kept) {
  Fields fields("tribolog-entry-1");
  add_facts(fields, id, facts, calibration_sha256(kept));
  add_quantities(fields, quantities);
  add_inputs(fields, inputs);
  return fields.hex();
}

std::string digest_of(const std::string& id, std::size_t place, const calibration::Review& review) {
  Fields fields("tribolog-review-1");
  fields.add(static_cast<std::uint64_t>(place));
  for (const std::string& text :
       {id, review.at_utc, review.reviewer, std::string(calibration::to_string(review.decision)),
        review.note}) {
    fields.add(text);
  }
  return fields.hex();
}

std::string id_of(const std::string& identity, int revision) {
  Fields fields("tribolog-id-1");
  fields.add(identity);
  fields.add(static_cast<std::uint64_t>(revision));
  return fields.hex();
}

std::string chain_link(const std::string& previous, const Event& event) {
  Fields fields("tribolog-chain-1");
  fields.add(previous);
  fields.add(static_cast<std::uint64_t>(event.number));
  for (const std::string& text : {event.at_utc, event.what, event.id, event.digest}) {
    fields.add(text);
  }
  return fields.hex();
}

std::string identity_of(const std::vector<calibration::Input>& inputs) {
  std::vector<std::string> fingerprints;
  for (const calibration::Input& input : inputs) {
    const bool is_of_joint = input.role.starts_with("manifest of joint ");
    fingerprints.push_back(input.sha256 + (is_of_joint ? input.role : ""));
  }
  std::sort(fingerprints.begin(), fingerprints.end());
  Fields fields("tribolog-identity-1");
  for (const std::string& fingerprint : fingerprints) fields.add(fingerprint);
  return fields.hex();
}

}  // namespace tribolog::archive::store
