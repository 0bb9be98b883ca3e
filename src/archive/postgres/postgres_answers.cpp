#include "archive/postgres/postgres_answers.h"

#include <bit>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "base/error.h"

namespace tribolog::archive::postgres {

namespace {

constexpr std::size_t longest_message = 400;

bool is_one_of(const std::string& state, std::initializer_list<const char*> states) {
  for (const char* const start : states) {
    if (state.starts_with(start)) return true;
  }
  return false;
}

}  // namespace

std::string in_one_line(const std::string& message) {
  std::string line;
  const char* gap = "";
  for (const char c : message) {
    if (c == '\n') {
      gap = "; ";
    } else if (c == ' ' || c == '\t') {
      if (*gap == '\0') gap = " ";
    } else {
      if (!line.empty()) line += gap;
      gap = "";
      line += c;
    }
  }
  return printable(line, longest_message);
}

void fail(const PostgresFailure& failure, const std::string& name, int wait_ms) {
  const std::string server = printable(name, longest_path) + ": ";
  const std::string said = in_one_line(failure.message);
  const std::string& state = failure.state;
  if (!failure.is_connected) {
    throw ArchiveError(server + "the connection to the server was lost (" + said +
                       "); what was not said to be archived may be missing: archive it again, the "
                       "same inputs are one entry");
  }
  if (state == "55P03") {
    throw ArchiveError(
        fmt::format("{}the archive is locked by another process, for more than {} s; nothing was "
                    "changed",
                    server, 1e-3 * wait_ms));
  }
  if (state == "25006" || (state == "42501" && failure.was_writing)) {
    throw OutputError(server + "the archive cannot be written (" + said + "); nothing was changed");
  }
  if (is_one_of(state, {"53100", "53400"})) {
    throw OutputError(server + "no space left for the archive (" + said + "); nothing was changed");
  }
  if (is_one_of(state, {"58"})) {
    throw OutputError(server + "the server cannot read or write the archive (" + said +
                      "); nothing was changed");
  }
  if (is_one_of(state, {"42P07", "42710"})) {
    throw ArchiveError(server + "no archive can be made beside another program's tables (" + said +
                       "); nothing was changed");
  }
  if (is_one_of(state, {"22", "23"})) {
    throw ArchiveError(server + "the archive's rules refuse this (" + said +
                       "); nothing was changed");
  }
  // Statements are right: what they name is missing, or something else.
  if (is_one_of(state, {"XX001", "XX002", "42", "0A"}) && state != "42501") {
    throw ArchiveError(server + "the archive is damaged (" + said +
                       "); it is left as it is; restore a backup");
  }
  throw ArchiveError(server + "the server refuses (" + said + "); nothing was changed");
}

namespace {

// Of the server's catalogue pg_type, the same in every version.
constexpr Oid inferred = 0;
constexpr Oid bytea = 17;
constexpr Oid bigint = 20;
constexpr Oid text = 25;
constexpr Oid double_precision = 701;

constexpr int binary = 1;
constexpr int bits_of_byte = 8;
constexpr std::size_t number_bytes = 8;

std::string most_significant_first(std::uint64_t number) {
  std::string bytes(number_bytes, '\0');
  for (std::size_t k = 0; k < number_bytes; ++k) {
    bytes[number_bytes - 1 - k] = static_cast<char>(number >> (bits_of_byte * k));
  }
  return bytes;
}

std::uint64_t number_of(std::string_view bytes) {
  if (bytes.size() != number_bytes) throw std::logic_error("a number of another size");
  std::uint64_t number = 0;
  for (const char byte : bytes) number = number << bits_of_byte | static_cast<unsigned char>(byte);
  return number;
}

}  // namespace

PostgresParameters::PostgresParameters(const std::vector<sql::Value>& values) {
  numbers_.reserve(values.size());  // the pointers into it stay
  for (const sql::Value& value : values) {
    if (const auto* whole = std::get_if<std::int64_t>(&value.content())) {
      add(bigint,
          numbers_.emplace_back(most_significant_first(static_cast<std::uint64_t>(*whole))));
    } else if (const auto* number = std::get_if<double>(&value.content())) {
      add(double_precision,
          numbers_.emplace_back(most_significant_first(std::bit_cast<std::uint64_t>(*number))));
    } else if (const auto* words = std::get_if<std::string>(&value.content())) {
      add(text, *words);
    } else if (const auto* blob = std::get_if<sql::Blob>(&value.content())) {
      add(bytea, blob->bytes);
    } else {
      types_.push_back(inferred);
      pointers_.push_back(nullptr);
      lengths_.push_back(0);
      formats_.push_back(binary);
    }
  }
}

void PostgresParameters::add(Oid type, const std::string& bytes) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw std::length_error("a value of more than 2 GB is too large for PostgreSQL");
  }
  types_.push_back(type);
  pointers_.push_back(bytes.data());
  lengths_.push_back(static_cast<int>(bytes.size()));
  formats_.push_back(binary);
}

sql::Value field_of(const PGresult* result, int row, int column) {
  if (PQgetisnull(result, row, column) != 0) return {};
  const std::string_view bytes(PQgetvalue(result, row, column),
                               static_cast<std::size_t>(PQgetlength(result, row, column)));
  switch (PQftype(result, column)) {
    case bigint:
      return static_cast<std::int64_t>(number_of(bytes));
    case double_precision:
      return std::bit_cast<double>(number_of(bytes));
    case text:
      return std::string(bytes);
    case bytea:
      return sql::Blob{std::string(bytes)};
    default:
      throw std::logic_error(fmt::format("PostgreSQL's type {} of column {}",
                                         PQftype(result, column), PQfname(result, column)));
  }
}

}  // namespace tribolog::archive::postgres
