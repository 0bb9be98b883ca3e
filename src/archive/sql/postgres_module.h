#pragma once
// What the module tribolog_postgres gives to the program.

#include <string>

#include "archive/sql/sql_connection.h"

/// As open_postgres() of postgres_connection.h. The caller owns it.
extern "C" __attribute__((visibility("default"))) tribolog::sql::Connection*
tribolog_postgres_connection(const std::string& uri, tribolog::sql::Access access, int wait_ms);
