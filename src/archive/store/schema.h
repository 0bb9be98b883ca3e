#pragma once
// The tables of an archive, and how older ones become today's.

#include "archive/sql/sql_connection.h"

namespace tribolog::archive::store {

/// Number of the schema that this program writes.
inline constexpr int schema_version = 3;

/// Older archives hold none.
inline constexpr int first_schema_with_reviews = 2;

/// Digests of older archives say nothing of the inputs that were kept.
inline constexpr int first_schema_with_wide_digests = 3;

/// Makes the tables, those of an older schema where asked for. Within a transaction.
void create_schema(sql::Connection& connection, int version = schema_version);

/// From schema 1, the first one, to 2: reviews. Within a transaction.
void add_reviews(sql::Connection& connection);

/// From schema 2 to 3: the same tables. Digests of entries that are added from now on cover the
/// documents kept with them, which an older program would take for an alteration.
void take_wider_digests(sql::Connection& connection);

/// 0 where there are no tables yet (a new PostgreSQL database).
int version_of(sql::Connection& connection);

/// Within a transaction, where tables are changed with it.
void set_version(sql::Connection& connection, int version);

/// @param known the newest schema that the program knows.
/// @throw ArchiveError: the archive's is newer, or it has no tables of an archive.
void refuse_other_versions(sql::Connection& connection, int known = schema_version);

// Whether an archive's tables are those that tribolog makes.

/// Holds tables, columns, indices and triggers against those of a new archive of the same schema:
/// in SQLite the whole text of each; on a server columns with their types, the number of rules and
/// indices of each table, and that it has neither triggers nor rewrite rules nor hidden rows.
/// @param version of the archive's schema, one that the program knows.
/// @throw ArchiveError naming the first that is missing, altered or of another program.
void refuse_damaged_schema(sql::Connection& connection, int version);

}  // namespace tribolog::archive::store
