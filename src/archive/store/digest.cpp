#include "archive/store/digest.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "files/sha256.h"

namespace tribolog::archive {
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

}  // namespace

std::string digest_of(const std::string& id, const Facts& f,
                      const std::vector<Quantity>& quantities, const std::vector<Input>& inputs,
                      const std::string& calibration_sha256) {
  Fields fields("tribolog-entry-1");
  for (const std::string* text :
       {&id, &f.of.robot, &f.of.serial, &f.of.joint, &f.measured_at, &f.measured_on, &f.created_utc,
        &f.operator_name, &f.note, &f.payload, &f.sentence, &f.configuration, &f.tool_version,
        &f.git_revision, &calibration_sha256}) {
    fields.add(*text);
  }
  fields.add(std::uint64_t{f.time_is_stated ? 1U : 0U});
  fields.add(to_string(f.verdict));
  for (const auto& number : {f.payload_kg, f.payload_distance_m, f.temperature_C, f.sampling_Hz}) {
    fields.add(number);
  }
  fields.add(f.gear_ratio);
  for (const Quantity& q : quantities) {
    for (const std::string& text : {q.name, q.words, q.unit, to_string(q.verdict)}) {
      fields.add(text);
    }
    fields.add(q.estimate ? std::optional(q.estimate->value) : std::nullopt);
    fields.add(q.estimate ? std::optional(q.estimate->low) : std::nullopt);
    fields.add(q.estimate ? std::optional(q.estimate->high) : std::nullopt);
  }
  for (const Input& input : inputs) {
    for (const std::string& text : {input.name, input.role, input.sha256}) fields.add(text);
    fields.add(input.bytes);
  }
  return fields.hex();
}

std::string digest_of(const std::string& id, std::size_t place, const Review& review) {
  Fields fields("tribolog-review-1");
  fields.add(static_cast<std::uint64_t>(place));
  for (const std::string& text :
       {id, review.at_utc, review.reviewer, std::string(to_string(review.decision)), review.note}) {
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

std::string NewCalibration::identity() const {
  std::vector<std::string> fingerprints;
  for (const Input& input : inputs) fingerprints.push_back(input.sha256);
  std::sort(fingerprints.begin(), fingerprints.end());
  Fields fields("tribolog-identity-1");
  for (const std::string& fingerprint : fingerprints) fields.add(fingerprint);
  return fields.hex();
}

}  // namespace tribolog::archive
