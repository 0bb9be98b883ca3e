#pragma once
// An archive in a database of a PostgreSQL server. What talks to it lies in a module, which is
// loaded for that alone.

#include <memory>
#include <string>

#include "archive/sql/sql_connection.h"

namespace tribolog::archive::sql {

/// Connects. write() waits for other writers at an advisory lock of the database; what it has kept
/// is on the server's disk even where the server is set to answer earlier
/// (`synchronous_commit = off`). A connection that was cut before a transaction is made again.
/// @param uri as libpq takes it; the password may also come from PGPASSWORD or ~/.pgpass, and no
///        message shows it.
/// @throw ArchiveError: the module or libpq is missing, no server, no such database, no right to
/// connect, or a database that is not
///        in UTF-8. @throw OutputError: read-only, with Access::write. @throw UsageError: no
///        connection string.
std::unique_ptr<Connection> open_postgres(const std::string& uri, Access access, int wait_ms);

}  // namespace tribolog::archive::sql

// What the module tribolog_postgres gives to the program.

/// note_kept() of base/early_end.h: what a signal has to say is the program's, not the module's.
using NoteKept = void (*)(const std::string& what);

/// As open_postgres(). The caller owns it.
extern "C" __attribute__((visibility("default"))) tribolog::archive::sql::Connection*
tribolog_postgres_connection(const std::string& uri, tribolog::archive::sql::Access access,
                             int wait_ms, NoteKept note_kept);
