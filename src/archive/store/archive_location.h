#pragma once
// Where an archive is: a file, or a PostgreSQL server.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "archive/sql/databases.h"
#include "archive/sql/sql_connection.h"
#include "archive/store/calibration_archive.h"

namespace tribolog::archive::store {

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

/// `tribolog/archive.tribolog` in the user's data directory by the XDG rules: $XDG_DATA_HOME, or
/// $HOME/.local/share.
/// @throw UsageError: neither is set to an absolute path.
std::string default_location();

/// "postgresql://..." or "postgres://..."; anything else is a file's path.
bool is_server(const std::string& location);

/// Whether something is there that may be an archive: a file, or a link; a server always counts.
/// @param location empty: default_location().
/// @throw UsageError: as default_location().
bool is_there(const std::string& location);

/// To be called before any computation where nothing is there: can a new archive be made? The
/// directories of the default one are made.
/// @param location empty: default_location().
/// @throw OutputError: no. UsageError: as default_location().
void check_can_be_made(const std::string& location);

/// @param location empty: default_location().
/// @param access with Access::write an archive that is not there is made, and the directories of
///        the default one; a server's database has to be there, its tables are made.
/// @throw InputError: not there, with Access::read. @throw ArchiveError, OutputError: as
///        open_sqlite() and open_postgres(); a newer schema.
CalibrationArchive open_archive(const std::string& location, sql::Access access,
                                int wait_ms = sql::usual_wait_ms);

}  // namespace tribolog::archive::store
