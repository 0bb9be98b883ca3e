// Messages in protobuf whose definitions or bytes are damaged, or ask for more than they have; the
// definitions are made by libprotobuf itself.

#include <cstdint>
#include <string>
#include <vector>

#include <google/protobuf/descriptor.pb.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "ingest/bags/as_in_csv.h"
#include "ingest/bags/bag_readers.h"
#include "support/damaged_files.h"
#include "support/mcap_writer.h"
#include "wording/words.h"

namespace tribolog::protobuf_messages_test {
namespace {

namespace pb = google::protobuf;
using Field = pb::FieldDescriptorProto;
using Names = std::vector<std::string>;

void add_field(pb::DescriptorProto& type, const std::string& name, Field::Type kind, bool is_list,
               const std::string& type_name = "") {
  Field& field = *type.add_field();
  field.set_name(name);
  field.set_number(type.field_size());
  field.set_type(kind);
  field.set_label(is_list ? Field::LABEL_REPEATED : Field::LABEL_OPTIONAL);
  if (!type_name.empty()) field.set_type_name(type_name);
}

pb::FileDescriptorProto file(const std::string& name) {
  pb::FileDescriptorProto made;
  made.set_name(name);
  made.set_package("arm");
  made.set_syntax("proto3");
  return made;
}

/// State {repeated string name; repeated double position; Inner inner}, Inner {int32 x; Inner
/// inner} from a file of its own, which stands behind the one that imports it.
pb::FileDescriptorSet state_files() {
  pb::FileDescriptorProto main = file("state.proto");
  main.add_dependency("inner.proto");
  pb::DescriptorProto& state = *main.add_message_type();
  state.set_name("State");
  add_field(state, "name", Field::TYPE_STRING, true);
  add_field(state, "position", Field::TYPE_DOUBLE, true);
  add_field(state, "inner", Field::TYPE_MESSAGE, false, ".arm.Inner");
  pb::FileDescriptorProto used = file("inner.proto");
  pb::DescriptorProto& inner = *used.add_message_type();
  inner.set_name("Inner");
  add_field(inner, "x", Field::TYPE_INT32, false);
  add_field(inner, "inner", Field::TYPE_MESSAGE, false, ".arm.Inner");
  pb::FileDescriptorSet set;
  *set.add_file() = main;
  *set.add_file() = used;
  return set;
}

std::string log_of(const std::string& set, const std::vector<std::string>& messages,
                   const std::string& type = "arm.State") {
  test::McapWriter writer({0, "", false, false});
  writer.add_schema(1, type, "protobuf", set);
  writer.add_channel(1, 1, "/state", "protobuf");
  for (std::size_t i = 0; i < messages.size(); ++i) writer.add_message(1, i, messages[i]);
  return writer.finish();
}

std::vector<ingest::log::LogTable> read(const std::string& bytes) {
  return ingest::bags::read_mcap_bytes(bytes, "a.mcap");
}

/// Of the topic, without what the reader says around it.
std::string reason_of(const std::string& set, const std::string& type = "arm.State") {
  const std::string said =
      test::refusal_of<InputError>([&] { return read(log_of(set, {""}, type)); });
  const std::string before = "/state is not read: ";
  const std::size_t begin = said.find(before) + before.size();
  return said.substr(begin, said.rfind(", expected") - begin);
}

/// name ["a", "b"], position [1, 2], inner {x: -1}.
const std::string message =
    std::string("\n\1a\n\1b\x12\x10\0\0\0\0\0\0\xf0\x3f\0\0\0\0\0\0\0\x40", 24) +
    std::string("\x1a\x0b\x08\xff\xff\xff\xff\xff\xff\xff\xff\xff\1", 13);

TEST(ProtobufMessages, ReadsDefinitionsInAnyOrder) {
  const auto tables = read(log_of(state_files().SerializeAsString(), {message, ""}));
  const ingest::log::LogTable& table = tables.at(0);
  EXPECT_EQ(table.header, (Names{"log_time [s]", "a.position", "b.position", "inner.x"}));
  EXPECT_EQ(table.columns[2].values[0], 2);
  EXPECT_EQ(table.columns[3].values[0], -1);
  EXPECT_TRUE(std::isnan(table.columns[3].values[1]));
}

TEST(ProtobufMessages, SaysWhatADefinitionLacks) {
  EXPECT_EQ(reason_of("\xff\xff"), "its schema is no FileDescriptorSet of protobuf, or is damaged");
  EXPECT_EQ(reason_of(state_files().SerializeAsString(), "arm.Other"),
            "its FileDescriptorSet does not define arm.Other");
  pb::FileDescriptorSet alone = state_files();
  alone.mutable_file()->RemoveLast();
  EXPECT_EQ(reason_of(alone.SerializeAsString()),
            "its FileDescriptorSet does not define arm.State: 'state.proto' imports 'inner.proto', "
            "which is not there or imports it in turn");
  pb::FileDescriptorSet circle = state_files();
  circle.mutable_file(1)->add_dependency("state.proto");
  EXPECT_EQ(reason_of(circle.SerializeAsString()),
            "its FileDescriptorSet does not define arm.State: 'state.proto' imports 'inner.proto', "
            "which is not there or imports it in turn");
  pb::FileDescriptorSet wrong = state_files();
  wrong.mutable_file(0)->mutable_message_type(0)->mutable_field(2)->set_type_name(".arm.Gone");
  EXPECT_EQ(reason_of(wrong.SerializeAsString()),
            "its FileDescriptorSet does not define arm.State: 'state.proto' is damaged: "
            "arm.State.inner: \".arm.Gone\" is not defined.");
}

TEST(ProtobufMessages, BoundsDefinitions) {
  EXPECT_EQ(reason_of(std::string((4 << 20) + 1, 'x')),
            "its FileDescriptorSet has 4194305 bytes, more than 4194304");
  pb::FileDescriptorSet many;
  for (int i = 0; i < 1001; ++i) *many.add_file() = file(std::to_string(i));
  EXPECT_EQ(reason_of(many.SerializeAsString()),
            "its FileDescriptorSet has 1001 files, more than 1000");
  pb::FileDescriptorSet chain;
  pb::FileDescriptorProto& links =
      *(*chain.add_file() = file("chain.proto"), chain.mutable_file(0));
  for (int i = 0; i < 1500; ++i) {
    pb::DescriptorProto& type = *links.add_message_type();
    type.set_name("T" + std::to_string(i));
    add_field(type, "next", Field::TYPE_MESSAGE, false, ".arm.T" + std::to_string((i + 1) % 1500));
  }
  EXPECT_EQ(reason_of(chain.SerializeAsString(), "arm.T0"),
            "its messages hold more than 1000 types");
}

TEST(ProtobufMessages, RefusesAMessageThatWouldFillTheMemory) {
  pb::FileDescriptorSet set;
  pb::FileDescriptorProto made = file("wide.proto");
  pb::DescriptorProto& wide = *made.add_message_type();
  wide.set_name("Wide");
  for (int i = 0; i < 5000; ++i)
    add_field(wide, "f" + std::to_string(i), Field::TYPE_DOUBLE, false);
  pb::DescriptorProto& state = *made.add_message_type();
  state.set_name("State");
  add_field(state, "parts", Field::TYPE_MESSAGE, true, ".arm.Wide");
  *set.add_file() = made;
  std::string parts;
  for (int i = 0; i < 200'000; ++i) parts += std::string("\n\0", 2);  // 40 kB each in memory
  const std::string said =
      test::refusal_of<InputError>([&] { return read(log_of(set.SerializeAsString(), {parts})); });
  EXPECT_EQ(said.substr(0, said.find(" (byte ")),
            "a.mcap: message 1 of /state has 400000 bytes, which may take more than 1073741824 in "
            "memory");
}

TEST(ProtobufMessages, SaysWhichMessageIsDamaged) {
  const std::string set = state_files().SerializeAsString();
  const auto refusal = [&](const std::string& second) {
    const std::string said =
        test::refusal_of<InputError>([&] { return read(log_of(set, {message, second})); });
    return said.substr(0, said.find(" (byte "));
  };
  EXPECT_EQ(refusal(message.substr(0, 30)), "a.mcap: message 2 of /state is not one of arm.State");
  std::string nested;
  for (int i = 0; i < 40; ++i) {
    nested = "\x12" + std::string(1, static_cast<char>(nested.size())) + nested;
  }
  EXPECT_EQ(refusal("\x1a" + std::string(1, static_cast<char>(nested.size())) + nested),
            "a.mcap: message 2 of /state is nested more than 32 deep");
}

TEST(ProtobufMessages, AnswersWhateverIsDamaged) {
  const std::string set = state_files().SerializeAsString();
  test::expect_mutants_answered(read, log_of(set, {message, message, message}), 500);
}

TEST(JsonMessages, AnswersWhateverIsDamaged) {
  test::McapWriter writer({0, "", false, false});
  writer.add_channel(1, 0, "/state", "json");
  for (int i = 0; i < 4; ++i) {
    writer.add_message(1, static_cast<std::uint64_t>(i),
                       R"({"header": {"stamp": {"sec": 1, "nanosec": 5}}, "name": ["a", "b"],)"
                       R"( "position": [1, -2.5e3], "joints": [{"name": "a", "q": NaN}]})");
  }
  test::expect_mutants_answered(read, writer.finish(), 500);
}

}  // namespace
}  // namespace tribolog::protobuf_messages_test
