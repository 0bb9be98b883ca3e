#include "ingest/bags/protobuf_module.h"

#include "base/program_module.h"
#include "ingest/messages/protobuf_decoder.h"
#include "ingest/messages/topic_tables.h"

namespace tribolog::ingest::bags {

std::unique_ptr<messages::TreeDecoder> protobuf_decoder(const std::string& type,
                                                        std::string_view schema) {
  try {
    void* const make =
        function_of({"tribolog_protobuf", TRIBOLOG_PROTOBUF_PACKAGES}, "tribolog_protobuf_decoder");
    std::unique_ptr<messages::TreeDecoder> decoder;
    reinterpret_cast<decltype(&tribolog_protobuf_decoder)>(make)(type, schema, decoder);
    return decoder;
  } catch (const MissingModule& missing) {
    throw messages::SchemaError(std::string("protobuf cannot be read here: ") + missing.what());
  }
}

}  // namespace tribolog::ingest::bags
