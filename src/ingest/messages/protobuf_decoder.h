#pragma once
// What the module tribolog_protobuf gives to the program.

#include <memory>
#include <string>
#include <string_view>

#include "ingest/messages/message_tree.h"

/// @param type full name of the messages' type, "foxglove.JointStates".
/// @param schema a serialized FileDescriptorSet that has it, and all that it uses.
/// @param decoder receives what reads them. Fields that are absent are gaps, but for those that
/// have
///        their default without being written (proto3); enumerations are their numbers; maps are
///        objects, their keys in ascending order; wrappers (google.protobuf.DoubleValue) are their
///        values.
/// @throw SchemaError: the set is damaged, is too large, or lacks the type or a file that it
/// imports.
extern "C" __attribute__((visibility("default"))) void tribolog_protobuf_decoder(
    const std::string& type, std::string_view schema,
    std::unique_ptr<tribolog::ingest::messages::TreeDecoder>& decoder);
