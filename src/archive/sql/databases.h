#pragma once
// The databases that an archive can be in: one SQLite file, or one of a PostgreSQL server.

#include <memory>
#include <string>

#include "archive/sql/sql_connection.h"

namespace tribolog::archive::sql {

// One SQLite file.

/// Says what the file is by SQLite's own field for it: "trib".
inline constexpr int application_id = 0x74726962;

/// Opens a file that exists. Rollback journal and `synchronous=EXTRA`: what was committed survives
/// a power failure, and the archive is one file.
/// @throw ArchiveError: no SQLite file, of another program, damaged or truncated; it is left as it
///        is. @throw OutputError: not writable, with Access::write. @throw InputError: not
///        readable.
std::unique_ptr<Connection> open_sqlite(const std::string& path, Access access, int wait_ms);

/// A database of its own that is kept nowhere, to see what statements make.
std::unique_ptr<Connection> sqlite_in_memory();

/// Makes the file with what `fill` writes to it, complete or not at all. One that another process
/// made meanwhile stays.
/// @throw OutputError: the directory cannot be written.
void create_sqlite(const std::string& path, const std::function<void(Connection&)>& fill);

/// A copy of what the archive holds now, in a file of its own, complete or not at all.
/// @throw OutputError: the file exists, or cannot be written.
void copy_sqlite(Connection& from, const std::string& path);

/// Everything SQLite itself finds wrong: pages, indices, rows without their calibration. Empty:
/// nothing.
std::vector<std::string> faults_of_sqlite(Connection& connection);

// A PostgreSQL server. What talks to it lies in a module, which is loaded for that alone.

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
