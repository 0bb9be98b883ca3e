#pragma once

#include "archive/archive_place.h"

#include "support/postgres_server.h"

namespace tribolog::test {

class PostgresPlace final : public ArchivePlace {
 public:
  [[nodiscard]] std::string location() const override { return uri_; }
  void run(const std::string& statements, bool cascades) override {
    const std::string role = cascades ? "origin" : "replica";
    server_.run("SET session_replication_role = " + role + "; " + statements, uri_);
  }
  void start_again() override {
    server_.run("DROP SCHEMA public CASCADE; CREATE SCHEMA public", uri_);
  }

 private:
  PostgresServer& server_{PostgresServer::of_this_program()};
  std::string uri_{server_.new_database()};
};

}  // namespace tribolog::test
