#pragma once
// What an archive's entries and events are proven by: SHA-256 over all of their fields.

#include <string>
#include <vector>

#include "archive/store/calibration_archive.h"
#include "calibration/archived_calibration.h"

namespace tribolog::archive::store {

/// Of an entry's facts, quantities and inputs and of the fingerprints of what was kept with it: its
/// calibration and, where wanted, its inputs. A report comes later and is a link of the chain. Each
/// field goes in with its length, each list with its own, numbers with all their bits.
std::string digest_of(const std::string& id, const calibration::Facts& facts,
                      const std::vector<calibration::Quantity>& quantities,
                      const std::vector<calibration::Input>& inputs,
                      const std::vector<StoredDocument>& kept);

/// The same as archives before schema 3 have it: of the documents the calibration's fingerprint
/// alone.
std::string narrow_digest_of(const std::string& id, const calibration::Facts& facts,
                             const std::vector<calibration::Quantity>& quantities,
                             const std::vector<calibration::Input>& inputs,
                             const std::vector<StoredDocument>& kept);

/// SHA-256 over the fingerprints of all inputs, manifest and recordings: what is measured again
/// is another calibration; the same is the same, whatever the settings, the program's version and
/// the files' names. Identified otherwise, it is a revision of the same. Joints whose manifest is
/// that of a whole robot share their files; the joint's name tells them apart then.
std::string identity_of(const std::vector<calibration::Input>& inputs);

/// Of a review: the place is its number among those of the entry, from 0.
std::string digest_of(const std::string& id, std::size_t place, const calibration::Review& review);

/// The id of a revision of an identity.
std::string id_of(const std::string& identity, int revision);

/// An addition, a removal, a review.
struct Event {
  std::int64_t number{};
  std::string at_utc;
  std::string what;
  std::string id;
  std::string digest;
};

/// The link that follows `previous`; empty: the first one.
std::string chain_link(const std::string& previous, const Event& event);

}  // namespace tribolog::archive::store
