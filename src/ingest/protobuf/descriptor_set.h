#pragma once
// The types that a log defines for its messages in protobuf.

#include <string>
#include <string_view>

#include <google/protobuf/descriptor.h>

namespace tribolog::ingest::protobuf {

/// @param set a serialized FileDescriptorSet, in any order.
/// @param pool receives its files, as far as the type needs them.
/// @return the message's type. @throw SchemaError as tribolog_protobuf_decoder().
const google::protobuf::Descriptor* type_in(std::string_view set, const std::string& type,
                                            google::protobuf::DescriptorPool& pool);

}  // namespace tribolog::ingest::protobuf
