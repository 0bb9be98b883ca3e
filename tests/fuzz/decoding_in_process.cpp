// In place of ingest/bags/protobuf_module.cpp: what the module gives, linked into the target, where
// its coverage is seen.

#include "ingest/bags/protobuf_module.h"
#include "ingest/messages/protobuf_decoder.h"

namespace tribolog::ingest::bags {

std::unique_ptr<messages::TreeDecoder> protobuf_decoder(const std::string& type,
                                                        std::string_view schema) {
  std::unique_ptr<messages::TreeDecoder> decoder;
  tribolog_protobuf_decoder(type, schema, decoder);
  return decoder;
}

}  // namespace tribolog::ingest::bags
