#pragma once
// Which reader the messages of a topic need.

#include <memory>

#include "ingest/messages/topic_tables.h"

namespace tribolog::ingest::bags {

/// CDR with a definition in ros2msg, or of a type that is known without one; ROS 1 with one in
/// ros1msg; JSON, whatever its schema; protobuf with its schema, by libprotobuf, which is loaded
/// here.
/// @throw SchemaError: another encoding, a definition that is not understood, or the library is
///        missing, and in which package it is.
std::unique_ptr<messages::MessageReader> reader_of(const messages::TopicDescription& topic);

}  // namespace tribolog::ingest::bags
