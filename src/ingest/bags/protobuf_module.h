#pragma once
// The module that reads messages in protobuf.

#include <memory>
#include <string>
#include <string_view>

#include "ingest/messages/message_tree.h"

namespace tribolog::ingest::bags {

/// Loads the module. @param type, schema as tribolog_protobuf_decoder() takes them.
/// @throw SchemaError as that does, or: the module, or the library that it stands on, is missing.
std::unique_ptr<messages::TreeDecoder> protobuf_decoder(const std::string& type,
                                                        std::string_view schema);

}  // namespace tribolog::ingest::bags
