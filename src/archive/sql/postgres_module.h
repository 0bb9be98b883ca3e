#pragma once
// What the module tribolog_postgres gives to the program.

#include <string>

#include "archive/sql/sql_connection.h"

/// note_kept() of files/early_end.h: what a signal has to say is the program's, not the module's.
using NoteKept = void (*)(const std::string& what);

/// As open_postgres() of postgres_connection.h. The caller owns it.
extern "C" __attribute__((visibility("default"))) tribolog::sql::Connection*
tribolog_postgres_connection(const std::string& uri, tribolog::sql::Access access, int wait_ms,
                             NoteKept note_kept);
