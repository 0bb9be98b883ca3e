// A file is what it holds, whatever its name ends in.

#include "inspect/files/file_kind.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/run_program.h"

namespace tribolog::test::file_kind_test {
namespace {

using inspect::files::FileKind;
using inspect::files::kind_of_file;

/// The header of an SQLite file of that application.
std::string sqlite_file(const std::string& application_id) {
  std::string bytes("SQLite format 3\0", 16);
  bytes.resize(100, '\0');
  bytes.replace(68, application_id.size(), application_id);
  return bytes;
}

std::string page_with(const std::string& body) {
  return "\n<!DOCTYPE html>\n<html><head></head><body>" + body + "</body></html>\n";
}

struct Content {
  std::string bytes;
  FileKind kind;
};

const std::vector<Content>& contents() {
  static const std::vector<Content> all{
      {"", FileKind::empty},
      {"measured on Monday\nby a friend\n", FileKind::unknown},
      {"{\"a\": [1, 2, 3]}", FileKind::unknown},
      {"schema = \"tribolog-dataset-1\"\n[robot]\nname = \"R\"\n", FileKind::manifest},
      {"# mine\r\nschema='tribolog-dataset-1'\r\n", FileKind::manifest},
      {"[robot]\nname = \"R\"\n[[recording]]\nrole = \"rough_sweep\"\n", FileKind::manifest},
      {"schema = \"tribolog-scenario-1\"\n", FileKind::scenario},
      {"schema = \"tribolog-joint-1\"\n", FileKind::joint},
      {"schema = \"tribolog-robot-1\"\n", FileKind::arm},
      {"<?xml version=\"1.0\"?>\n<robot name=\"r\"></robot>\n", FileKind::arm},
      {page_with("<script id=\"tribolog-result\">{}</script>"), FileKind::report},
      {page_with("<script id=\"tribolog-robot\">{}</script>"), FileKind::robot_page},
      {page_with("<script id=\"tribolog-diff\">{}</script>"), FileKind::other_page},
      {page_with("<meta name=\"generator\" content=\"tribolog 0.1.0\">"), FileKind::bare_page},
      {page_with("tribolog-result"), FileKind::foreign_page},
      {"{\"schema\": \"tribolog-calibration-1\"}", FileKind::calibration},
      {"{\"cases\": [" + std::string(100'000, ' ') + "], \"schema\": \"tribolog-calibration-1\"}",
       FileKind::calibration},
      {"{\"q\": [" + std::string(3'000'000, ' ') + "]}", FileKind::unknown},
      {"{\"schema\": \"tribolog-plan-1\"}", FileKind::plan},
      {"{\"schema\": \"tribolog-truth-1\"}", FileKind::truth},
      {"{\"schema\": \"tribolog-robot-truth-1\"}", FileKind::truth},
      {"{\"schema\": \"tribolog-study-1\"}", FileKind::other_json},
      {sqlite_file("trib"), FileKind::archive},
      {sqlite_file(std::string(4, '\0')), FileKind::log},
      {"\x89MCAP0\r\n", FileKind::log},
      {"t,q,tau\n0,1,2\n0.1,1.1,2\n0.2,1.2,2\n", FileKind::log},
      {"t;q;tau\n0,0;1,1;2,5\n0,1;1,2;2,5\n0,2;1,3;2,5\n", FileKind::log},
  };
  return all;
}

TEST(FileKind, IsThatOfTheContentUnderAnyName) {
  const ScratchDirectory scratch;
  for (const Content& one : contents()) {
    for (const char* name : {"a.toml", "a.csv", "a.html", "a.json", "a.db", "a"}) {
      EXPECT_EQ(kind_of_file(scratch.write(name, one.bytes)), one.kind)
          << name << ": " << one.bytes.substr(0, 60);
    }
  }
}

TEST(FileKind, OfWhatIsNoFile) {
  const ScratchDirectory scratch;
  EXPECT_EQ(kind_of_file(scratch.file("gone")), FileKind::missing);
  EXPECT_EQ(kind_of_file(scratch.path()), FileKind::folder);
  EXPECT_EQ(kind_of_file("/dev/null"), FileKind::unknown);
}

}  // namespace
}  // namespace tribolog::test::file_kind_test
