#pragma once
// Internal to the store: one entry of an archive, held against its digest and its chain.

#include <map>
#include <string>
#include <vector>

#include "archive/sql/sql_connection.h"
#include "calibration/archived_calibration.h"

namespace tribolog::archive::store {

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
