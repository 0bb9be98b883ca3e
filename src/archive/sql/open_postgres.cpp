#include <memory>
#include <string>

#include "archive/sql/databases.h"
#include "base/early_end.h"
#include "base/error.h"
#include "base/program_module.h"

namespace tribolog::archive::sql {

std::unique_ptr<Connection> open_postgres(const std::string& uri, Access access, int wait_ms) {
  try {
    void* const open = function_of({"tribolog_postgres", TRIBOLOG_POSTGRES_PACKAGES},
                                   "tribolog_postgres_connection");
    return std::unique_ptr<Connection>(reinterpret_cast<decltype(&tribolog_postgres_connection)>(
        open)(uri, access, wait_ms, note_kept));
  } catch (const MissingModule& missing) {
    throw ArchiveError(std::string("no archive on a PostgreSQL server can be opened here: ") +
                       missing.what());
  }
}

}  // namespace tribolog::archive::sql
