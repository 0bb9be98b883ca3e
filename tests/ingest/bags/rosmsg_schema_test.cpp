// The .msg language.

#include "ingest/bags/rosmsg_schema.h"

#include <gtest/gtest.h>

#include "base/temporary_directory.h"
#include "support/cdr_writer.h"

namespace tribolog::ros2msg_schema_test {
namespace {

std::string refusal_of(const std::string& text) {
  return test::refusal_of<ingest::bags::SchemaError>(
      [&] { return ingest::bags::parse_ros2msg("pkg/msg/Root", text); });
}

TEST(Ros2msgSchema, ReadsFieldsOfEveryForm) {
  const ingest::bags::MessageSchema schema =
      ingest::bags::parse_ros2msg("pkg/msg/Root",
                                  "# comment\r\n"
                                  "uint8 MODE_IDLE=1\n"
                                  "string NAME = \"a # b\"\n"
                                  "  float64   one  1.5   # with its value\n"
                                  "int16[3] fixed\n"
                                  "bool[] any [true]\n"
                                  "uint8[<=4] bounded\n"
                                  "string<=7[<=2] words\n"
                                  "string text \"x = y\"\n"
                                  "Part part#comment\n"
                                  "other_pkg/Part[2] parts\n"
                                  "=====\n"
                                  "MSG: pkg/msg/Part\n"
                                  "float32 x\n"
                                  "=====\n"
                                  "MSG: other_pkg/Part\n"
                                  "int64 y\n");
  using Kind = ingest::bags::MessageField::Kind;
  using Count = ingest::bags::MessageField::Count;
  ASSERT_EQ(schema.types.size(), 3U);
  const std::vector<ingest::bags::MessageField>& fields = schema.types[0].fields;
  ASSERT_EQ(fields.size(), 8U);
  EXPECT_EQ(fields[0].name, "one");
  EXPECT_EQ(fields[0].primitive, ingest::bags::Primitive::float64);
  EXPECT_EQ(fields[1].count, Count::fixed);
  EXPECT_EQ(fields[1].elements, 3U);
  EXPECT_EQ(fields[2].count, Count::sequence);
  EXPECT_EQ(fields[2].primitive, ingest::bags::Primitive::boolean);
  EXPECT_EQ(fields[3].count, Count::sequence);
  EXPECT_EQ(fields[4].kind, Kind::string);
  EXPECT_EQ(fields[4].count, Count::sequence);
  EXPECT_EQ(fields[5].name, "text");
  EXPECT_EQ(fields[6].name, "part");
  EXPECT_EQ(schema.types[fields[6].type].name, "pkg/Part");
  EXPECT_EQ(schema.types[fields[7].type].name, "other_pkg/Part");
  EXPECT_EQ(schema.types[fields[7].type].fields.at(0).primitive, ingest::bags::Primitive::int64);
}

TEST(Ros2msgSchema, TakesKnownTypesWhereTheTextLacksThem) {
  const ingest::bags::MessageSchema schema =
      ingest::bags::parse_ros2msg("pkg/Root", "sensor_msgs/msg/JointState state");
  ASSERT_EQ(schema.types.size(), 4U);
  EXPECT_EQ(schema.types[1].name, "sensor_msgs/JointState");
  EXPECT_EQ(schema.types[3].name, "builtin_interfaces/Time");
}

TEST(Ros2msgSchema, RefusesWhatItDoesNotUnderstand) {
  EXPECT_EQ(refusal_of("float64 x\nMissing y\n"), "type 'pkg/Missing' is not defined");
  EXPECT_EQ(refusal_of("Root again\n"), "pkg/Root contains itself");
  EXPECT_EQ(refusal_of("A a\n===\nMSG: pkg/A\nB b\n===\nMSG: pkg/B\nA[] a\n"),
            "pkg/A contains itself");
  EXPECT_EQ(refusal_of("\nwstring x\n"), "line 2 of pkg/Root: wstring is not read");
  EXPECT_EQ(refusal_of("float64\n"), "line 1 of pkg/Root: 'float64' is no field: it has no name");
  EXPECT_EQ(refusal_of("float64[x] a\n"), "line 1 of pkg/Root: 'x' is no number of elements");
  EXPECT_EQ(refusal_of("float64[ a\n"), "line 1 of pkg/Root: a bracket is not closed");
  EXPECT_EQ(refusal_of("float64 x\n===\nfloat64 y\n"),
            "a line of = is followed by 'float64 y', not by 'MSG: package/Type'");
}

TEST(Ros2msgSchema, AnswersEveryPrefixOfADefinition) {
  const std::string text(test::joint_state_definition);
  for (std::size_t n = 0; n <= text.size(); ++n) {
    const std::string refusal = refusal_of(text.substr(0, n));
    ASSERT_EQ(refusal.find("other: "), std::string::npos) << refusal;
  }
}

}  // namespace
}  // namespace tribolog::ros2msg_schema_test
