#pragma once
// Whether an archive's tables are those that tribolog makes.

#include "archive/sql/sql_connection.h"

namespace tribolog::archive::store {

/// Holds tables, columns, indices and triggers against those of a new archive of the same schema:
/// in SQLite the whole text of each; on a server columns with their types, the number of rules and
/// indices of each table, and that it has neither triggers nor rewrite rules nor hidden rows.
/// @param version of the archive's schema, one that the program knows.
/// @throw ArchiveError naming the first that is missing, altered or of another program.
void refuse_damaged_schema(sql::Connection& connection, int version);

}  // namespace tribolog::archive::store
