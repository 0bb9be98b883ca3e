// Messages of any type of ROS as columns.

#include "ingest/bags/schema_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

#include "base/temporary_directory.h"
#include "support/cdr_writer.h"

namespace tribolog::schema_columns_test {
namespace {

using test::CdrWriter;
using Values = std::vector<double>;
using Names = std::vector<std::string>;

/// Messages of one type in CDR.
struct TypedColumns {
  TypedColumns(std::string_view type, std::string_view definition)
      : reader(ingest::bags::parse_ros2msg(type, definition), ingest::bags::Serialization::cdr) {}
  ingest::bags::SchemaReader reader;
  ingest::messages::MessageColumns columns;
};

std::optional<std::int64_t> take(TypedColumns& typed, const test::CdrWriter& writer) {
  return typed.reader.take_row(writer.message(), typed.columns);
}

Names names_of(const std::vector<ingest::log::LogColumn>& columns) {
  Names names;
  for (const ingest::log::LogColumn& column : columns) names.push_back(column.header.name);
  return names;
}

// A state as arms with torque sensors publish it: joints by name inside, arrays, a mode.
constexpr std::string_view arm_definition =
    "std_msgs/Header header\n"
    "Flags flags\n"
    "sensor_msgs/JointState measured\n"
    "float64[2] dtau\n"
    "geometry_msgs/Wrench[] wrenches\n"
    "float64 time\n"
    "uint8 MODE_IDLE=1\n"
    "uint8 mode\n"
    "Nothing nothing\n"
    "float32 last\n"
    "===\nMSG: arm_msgs/Flags\nbool[3] contact\n"
    "===\nMSG: arm_msgs/Nothing\n# no fields\n"
    "===\nMSG: geometry_msgs/Wrench\nVector3 force\n"
    "===\nMSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\n";

test::CdrWriter arm_message(double value) {
  test::CdrWriter writer;
  writer.add_header(5'000'000'006, "arm");
  for (const std::uint8_t contact : {1, 0, 1}) writer.add(contact);
  writer.add_header(7, "odd").add_texts({"j1", "j2"}).add_sequence<double>({value, 2});
  writer.add_sequence<double>({}).add_sequence<double>({3, 4});
  writer.add(5.0).add(6.0);
  writer.add(std::uint32_t{1}).add(7.0).add(8.0);
  writer.add(9.0).add(std::uint8_t{2}).add(std::uint8_t{0}).add(1.5F);
  return writer;
}

TEST(SchemaColumns, NamesNumbersByTheirPathAndJointsByName) {
  TypedColumns columns("arm_msgs/msg/Arm", arm_definition);
  take(columns, arm_message(1));
  take(columns, arm_message(-1));
  EXPECT_EQ(columns.columns.too_long(), 0U);
  const std::vector<ingest::log::LogColumn> finished = std::move(columns.columns).finish();
  EXPECT_EQ(
      names_of(finished),
      (Names{"flags.contact[0]", "flags.contact[1]", "flags.contact[2]",
             "measured.header.stamp.sec", "measured.header.stamp.nanosec", "measured.j1.position",
             "measured.j2.position", "measured.j1.effort", "measured.j2.effort", "dtau[0]",
             "dtau[1]", "wrenches[0].force.x", "wrenches[0].force.y", "time", "mode", "last"}));
  EXPECT_EQ(finished[5].values, (Values{1, -1}));
  EXPECT_EQ(finished[8].values, (Values{4, 4}));
  EXPECT_EQ(finished[15].values, (Values{1.5, 1.5}));
}

TEST(SchemaColumns, TakesWhatIsNoNumberForAGap) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  TypedColumns columns("arm_msgs/msg/Arm", arm_definition);
  for (const double value : {1.5, infinity, -infinity, std::nan(""), 2.5}) {
    take(columns, arm_message(value));
  }
  const std::vector<ingest::log::LogColumn> found = std::move(columns.columns).finish();
  const auto column = std::find_if(
      found.begin(), found.end(),
      [](const ingest::log::LogColumn& one) { return one.header.name == "measured.j1.position"; });
  ASSERT_NE(column, found.end());
  EXPECT_EQ(column->gaps, 3U);
  EXPECT_EQ(column->values.front(), 1.5);
  EXPECT_EQ(column->values.back(), 2.5);
  for (const std::size_t row : {1U, 2U, 3U}) EXPECT_TRUE(std::isnan(column->values[row])) << row;
}

TEST(SchemaColumns, GivesTheStampInNanoseconds) {
  TypedColumns columns("arm_msgs/msg/Arm", arm_definition);
  EXPECT_EQ(take(columns, arm_message(0)), 5'000'000'006);
}

TEST(SchemaColumns, NamesInterfacesOfDynamicJointState) {
  TypedColumns columns("control_msgs/msg/DynamicJointState",
                       "std_msgs/Header header\nstring[] joint_names\n"
                       "InterfaceValue[] interface_values\n");
  const auto message = [](const Names& joints, double value) {
    test::CdrWriter writer;
    writer.add_header(0).add_texts(joints).add(std::uint32_t{2});
    writer.add_texts({"position", "motor_temperature"}).add_sequence<double>({value, 40});
    return writer.add_texts({"torque"}).add_sequence<double>({value + 1});
  };
  take(columns, message({"a", "b"}, 1));
  take(columns, message({"b", "a"}, 5));
  const std::vector<ingest::log::LogColumn> finished = std::move(columns.columns).finish();
  EXPECT_EQ(names_of(finished), (Names{"a.position", "a.motor_temperature", "b.torque",
                                       "b.position", "b.motor_temperature", "a.torque"}));
  EXPECT_EQ(finished[0].values.at(0), 1);
  EXPECT_TRUE(std::isnan(finished[0].values.at(1)));
  EXPECT_EQ(finished[0].gaps, 1U);
  EXPECT_EQ(finished[3].values.at(1), 5);
  EXPECT_EQ(finished[5].values.at(1), 6);
}

TEST(SchemaColumns, LeavesOutImagesAndCountsWhatIsTooLong) {
  TypedColumns columns("pkg/Image", "uint32 width\nuint8[] data\nfloat64 gain\n");
  const std::vector<std::uint8_t> pixels(100'000, 3);
  take(columns, test::CdrWriter().add(std::uint32_t{5}).add_sequence(pixels).add(0.5));
  take(columns, test::CdrWriter().add(std::uint32_t{5}).add_sequence(pixels).add(0.5).add(1.0));
  EXPECT_EQ(columns.columns.long_arrays(), Names{"data"});
  EXPECT_EQ(columns.columns.too_long(), 1U);
  EXPECT_EQ(names_of(std::move(columns.columns).finish()), (Names{"width", "gain"}));
}

TEST(SchemaColumns, KeepsTheNumberOfColumnsBounded) {
  TypedColumns columns("sensor_msgs/JointState", "string[] name\nfloat64[] position\n");
  const auto message = [](int first, int last) {
    Names names;
    for (int i = first; i < last; ++i) names.push_back(std::to_string(i));
    return test::CdrWriter().add_texts(names).add_sequence(Values(names.size(), 1));
  };
  take(columns, message(0, 5000));
  EXPECT_FALSE(columns.columns.has_too_many_columns());
  take(columns, message(4999, 50'000));
  EXPECT_TRUE(columns.columns.has_too_many_columns());
  EXPECT_EQ(std::move(columns.columns).finish().size(), 5000U);
}

}  // namespace
}  // namespace tribolog::schema_columns_test
