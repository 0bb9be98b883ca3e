#pragma once
// From an older program's tables to today's.

#include <functional>
#include <string>
#include <vector>

#include "archive/sql/sql_connection.h"

namespace tribolog::archive {

/// Brings a schema to the next number.
using UpgradeStep = std::function<void(sql::Connection&)>;

/// The steps behind schema 1, in their order: as many as schema_version says.
const std::vector<UpgradeStep>& upgrade_steps();

/// Applies the steps that the archive lacks, all of them or none, in one transaction. An SQLite
/// file is copied before, to `FILE.schema-N` beside it; a copy that is there already is kept.
/// @return the schema's number before; that of the steps where nothing was to be done.
/// @throw ArchiveError: the schema is newer, or no archive's. @throw OutputError: no room for the
/// copy.
int upgrade(sql::Connection& connection, const std::vector<UpgradeStep>& steps);

}  // namespace tribolog::archive
