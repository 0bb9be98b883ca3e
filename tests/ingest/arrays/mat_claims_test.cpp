// What a MAT 5 file claims against what it holds: the library would fill up with zeros.

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <zlib.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "ingest/arrays/array_readers.h"
#include "support/damaged_files.h"

namespace tribolog::mat_claims_test {
namespace {

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

std::string part(std::uint32_t kind, std::string bytes) {
  const std::string tag = bytes_of<std::uint32_t>({kind, static_cast<std::uint32_t>(bytes.size())});
  bytes.resize((bytes.size() + 7) / 8 * 8);
  return tag + bytes;
}

/// The names of a struct's fields, each of so many bytes.
std::string fields(std::uint32_t name_bytes, const std::string& names) {
  constexpr std::uint32_t short_int_32 = 4U << 16U | 5U;
  return bytes_of<std::uint32_t>({short_int_32, name_bytes}) + part(1, names);
}

/// The header of an array, by its class and sides, and what is in it.
std::string array(std::uint32_t array_class, const std::vector<std::int32_t>& sides,
                  const std::string& name, const std::string& inside) {
  return part(14, part(6, bytes_of<std::uint32_t>({array_class, 0})) + part(5, bytes_of(sides)) +
                      part(1, name) + inside);
}

std::string doubles(const std::vector<std::int32_t>& sides, const std::string& name,
                    std::size_t values) {
  return array(6, sides, name, part(9, bytes_of(std::vector<double>(values, 1.5))));
}

std::string packed(const std::string& bytes) {
  uLongf length = compressBound(bytes.size());
  std::string out(length, '\0');
  compress(reinterpret_cast<Bytef*>(out.data()), &length,
           reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  return bytes_of<std::uint32_t>({15, static_cast<std::uint32_t>(length)}) + out.substr(0, length);
}

class MatClaims : public testing::Test {
 protected:
  std::string write(const std::string& variables) {
    std::string header(124, ' ');
    header.replace(0, 10, "MATLAB 5.0");
    return directory_.file("a.mat", header + std::string("\x00\x01IM", 4) + variables);
  }
  /// Without the path.
  std::string refusal(const std::string& variables) {
    const std::string path = write(variables);
    return test::refusal_of<InputError>([&] { return ingest::arrays::read_mat(path); })
        .substr(path.size());
  }
  test::TemporaryDirectory directory_;
};

TEST_F(MatClaims, KeptClaimsAreRead) {
  const std::string field_names = fields(8, std::string("q\0\0\0\0\0\0\0", 8));
  const std::string structure = array(2, {1, 1}, "run", field_names + doubles({20, 2}, "", 40));
  const std::string variables = doubles({20, 1}, "t", 20) + structure +
                                array(6, {0, 0}, "none", part(9, "")) +
                                array(1, {1, 1}, "cell", part(14, ""));
  for (const std::string& form :
       {variables, packed(doubles({20, 1}, "t", 20)) + packed(structure)}) {
    const auto tables = ingest::arrays::read_mat(write(form));
    ASSERT_EQ(tables.size(), 1U);
    EXPECT_EQ(tables[0].header, (std::vector<std::string>{"t", "run.q_0", "run.q_1"}));
    EXPECT_EQ(tables[0].columns[2].values, std::vector<double>(20, 1.5));
  }
}

TEST_F(MatClaims, FewerValuesThanTheSidesClaim) {
  const std::string good = doubles({20, 1}, "t", 20);
  const std::string claims = ": damaged MAT file: variable 2 claims more values than it has";
  EXPECT_EQ(refusal(good + doubles({21, 1}, "q", 20)), claims);
  EXPECT_EQ(refusal(good + packed(doubles({1000, 1000}, "q", 20))), claims);
  EXPECT_EQ(refusal(good + doubles({2147483647, 2147483647, 2147483647}, "q", 20)), claims);
  EXPECT_EQ(refusal(good + array(1, {1000, 1}, "cell", doubles({1, 1}, "", 1))), claims);
  const std::string nested = fields(8, "abcdefgh") + doubles({3, 1}, "", 2);
  EXPECT_EQ(refusal(good + array(2, {1, 1}, "run", nested)), claims);
  const std::string lacking = fields(1, std::string(40, 'a')) + doubles({2, 1}, "", 2);
  EXPECT_EQ(refusal(good + array(2, {1, 1}, "run", lacking)), claims);
}

TEST_F(MatClaims, PartsThatDoNotFit) {
  std::string longer = doubles({2, 1}, "q", 2);
  longer[8 + 16 + 16 + 16 + 4] = 127;  // the length of its values
  EXPECT_EQ(refusal(longer),
            ": damaged MAT file: variable 1 has a part that is longer than itself");
  EXPECT_EQ(refusal(array(6, {-2, 1}, "q", "")),
            ": damaged MAT file: variable 1 has sides that cannot be");
  EXPECT_EQ(refusal(part(14, part(9, "01234567"))),
            ": damaged MAT file: variable 1 has no header of an array");
  std::string deep = doubles({1, 1}, "", 1);
  for (int i = 0; i < 100; ++i) deep = array(1, {1, 1}, "c", deep);
  EXPECT_EQ(refusal(deep), ": damaged MAT file: variable 1 is nested too deeply");
}

}  // namespace
}  // namespace tribolog::mat_claims_test
