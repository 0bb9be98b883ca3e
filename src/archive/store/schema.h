#pragma once
// The tables of an archive, and how older ones become today's.

#include "archive/sql/sql_connection.h"

namespace tribolog::archive {

/// Number of the schema that this program writes.
inline constexpr int schema_version = 1;

/// Makes the tables. Within a transaction.
void create_schema(sql::Connection& connection);

/// 0 where there are no tables yet (a new PostgreSQL database).
int version_of(sql::Connection& connection);

/// @throw ArchiveError: the schema is newer than the program, or one that it does not know.
void refuse_other_versions(sql::Connection& connection);

}  // namespace tribolog::archive
