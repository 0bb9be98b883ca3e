// Numbers and strings at their places in CDR, in both byte orders.

#include "ingest/bags/cdr_reader.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/temporary_directory.h"
#include "support/cdr_writer.h"

namespace tribolog::cdr_reader_test {
namespace {

using namespace std::string_literals;

std::string refusal_of(const std::string& message, const auto& action) {
  return test::refusal_of<ingest::bags::MessageError>([&] {
    ingest::bags::CdrReader reader(message);
    return action(reader);
  });
}

TEST(CdrReader, ReadsWhatTheStandardShowsByteForByte) {
  // octet 1, then a double 1.0 at 8, a string "ab", a short -2 at 24 (after 4 + 3 bytes at 16).
  const std::string little =
      "\0\1\0\0"s + "\1\0\0\0\0\0\0\0"s + "\0\0\0\0\0\0\xf0\x3f"s + "\3\0\0\0ab\0"s + "\0\xfe\xff"s;
  const std::string big =
      "\0\0\0\0"s + "\1\0\0\0\0\0\0\0"s + "\x3f\xf0\0\0\0\0\0\0"s + "\0\0\0\3ab\0"s + "\0\xff\xfe"s;
  for (const std::string& message : {little, big}) {
    ingest::bags::CdrReader reader(message);
    EXPECT_EQ(reader.number(ingest::bags::Primitive::uint8), 1);
    EXPECT_EQ(reader.number(ingest::bags::Primitive::float64), 1);
    EXPECT_EQ(reader.string(), "ab");
    EXPECT_EQ(reader.number(ingest::bags::Primitive::int16), -2);
    EXPECT_EQ(reader.bytes_left(), 0U);
  }
}

template <class Number>
void expect_aligned(ingest::bags::Primitive kind, Number value) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    for (int before = 0; before < 9; ++before) {
      test::CdrWriter writer(order);
      for (int i = 0; i < before; ++i) writer.add(std::uint8_t{0xaa});
      const std::string message = writer.add(value).add(std::uint8_t{7}).message();
      ingest::bags::CdrReader reader(message);
      reader.skip(ingest::bags::Primitive::uint8, static_cast<std::size_t>(before));
      ASSERT_EQ(reader.number(kind), static_cast<double>(value)) << before << " bytes before";
      ASSERT_EQ(reader.number(ingest::bags::Primitive::uint8), 7);
    }
  }
}

TEST(CdrReader, AlignsEveryKindFromEveryOffsetInBothOrders) {
  expect_aligned<std::int8_t>(ingest::bags::Primitive::int8, -128);
  expect_aligned<std::uint8_t>(ingest::bags::Primitive::uint8, 255);
  expect_aligned<std::int16_t>(ingest::bags::Primitive::int16, -32768);
  expect_aligned<std::uint16_t>(ingest::bags::Primitive::uint16, 65535);
  expect_aligned<std::int32_t>(ingest::bags::Primitive::int32,
                               std::numeric_limits<std::int32_t>::min());
  expect_aligned<std::uint32_t>(ingest::bags::Primitive::uint32,
                                std::numeric_limits<std::uint32_t>::max());
  expect_aligned<std::int64_t>(ingest::bags::Primitive::int64, -(std::int64_t{1} << 53));
  expect_aligned<std::uint64_t>(ingest::bags::Primitive::uint64, std::uint64_t{1} << 63);
  expect_aligned<float>(ingest::bags::Primitive::float32, -0.1F);
  expect_aligned<double>(ingest::bags::Primitive::float64, 1e-308);
}

TEST(CdrReader, SkipsAsFarAsItReads) {
  for (int before = 0; before < 9; ++before) {
    test::CdrWriter writer;
    for (int i = 0; i < before; ++i) writer.add(std::uint8_t{0});
    for (int i = 0; i < 3; ++i) writer.add(1.5);
    const std::string message = writer.add(std::uint8_t{9}).message();
    ingest::bags::CdrReader reader(message);
    reader.skip(ingest::bags::Primitive::uint8, static_cast<std::size_t>(before));
    reader.skip(ingest::bags::Primitive::float64, 3);
    reader.skip(ingest::bags::Primitive::float64, 0);  // no elements, no padding
    EXPECT_EQ(reader.number(ingest::bags::Primitive::uint8), 9);
  }
}

TEST(CdrReader, RefusesOtherRepresentations) {
  const auto nothing = [](ingest::bags::CdrReader&) { return 0; };
  EXPECT_EQ(refusal_of("\0\1"s, nothing), "has 2 bytes, too few for CDR");
  EXPECT_EQ(refusal_of("\0\3\0\0"s, nothing),
            "starts with 0x0003, not with 0x0000 or 0x0001 of plain CDR");
}

TEST(CdrReader, HoldsEveryLengthAgainstWhatIsLeft) {
  const std::string most = test::CdrWriter().add(~std::uint32_t{0}).add(1.0).message();
  EXPECT_EQ(refusal_of(most, [](ingest::bags::CdrReader& reader) { return reader.string(); }),
            "ends too early: 4294967295 bytes wanted at its byte 8, 12 left");
  EXPECT_EQ(
      refusal_of(most, [](ingest::bags::CdrReader& reader) { return reader.sequence_length(); }),
      "states 4294967295 elements before its byte 8, but only 12 bytes are left");
  const auto skip_all = [](ingest::bags::CdrReader& reader) {
    reader.skip(ingest::bags::Primitive::float64, std::numeric_limits<std::size_t>::max());
    return 0;
  };
  EXPECT_NE(refusal_of(most, skip_all), "");
  const std::string full = test::CdrWriter().add_text("abc").add(2.0).message();
  const auto read_all = [](ingest::bags::CdrReader& reader) {
    (void)reader.string();
    return reader.number(ingest::bags::Primitive::float64);
  };
  EXPECT_EQ(refusal_of(full, read_all), "");
  for (std::size_t n = 0; n < full.size(); ++n) {
    EXPECT_NE(refusal_of(full.substr(0, n), read_all), "") << n << " bytes";
  }
}

TEST(CdrReader, TakesStringsWithoutClosingNul) {
  const std::string bare = "\0\1\0\0\2\0\0\0ab\0\0\0\0\0\0"s;
  ingest::bags::CdrReader reader(bare);
  EXPECT_EQ(reader.string(), "ab");
  EXPECT_EQ(reader.string(), "");  // length 0
}

}  // namespace
}  // namespace tribolog::cdr_reader_test
