#pragma once
// Which server an archive is on, by its connection string.

#include <string>

namespace tribolog::sql {

/// A connection string that libpq understands, and what may be shown of it.
struct PostgresLocation {
  std::string uri;    ///< For libpq; may hold a password.
  std::string shown;  ///< "postgresql://user@host:port/database", as far as it states these.
};

/// @param uri "postgresql://user:password@host:port/database?option=value"; as libpq takes them.
/// @throw UsageError: not of this form, or an `@` whose place makes it unclear where a password
///        ends. The message repeats nothing of the string.
PostgresLocation postgres_location(const std::string& uri);

}  // namespace tribolog::sql
