#pragma once
// An archive in one SQLite file.

#include <memory>
#include <string>

#include "archive/sql/sql_connection.h"

namespace tribolog::archive::sql {

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

}  // namespace tribolog::archive::sql
