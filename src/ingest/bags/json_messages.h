#pragma once
// Messages in JSON, each a document of its own.

#include <string_view>

#include "ingest/messages/message_tree.h"

namespace tribolog::ingest::bags {

/// Booleans are 0 and 1; null, and NaN and Infinity (which Python writes), are gaps.
class JsonDecoder final : public messages::TreeDecoder {
 public:
  /// @throw MessageError: it is no JSON (with its byte), is nested too deeply or has too many
  /// values.
  void decode(std::string_view message, messages::MessageTree& tree) override;
};

}  // namespace tribolog::ingest::bags
