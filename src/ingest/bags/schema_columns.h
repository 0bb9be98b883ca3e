#pragma once
// Messages whose type is defined beside them, as ROS writes them, as columns.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "ingest/bags/cdr_reader.h"
#include "ingest/bags/rosmsg_schema.h"
#include "ingest/messages/message_columns.h"

namespace tribolog::ingest::bags {

/// The elements of arrays have names in sensor_msgs/JointState, `<joint>.position`, `.velocity`,
/// `.effort`, and in control_msgs/DynamicJointState, `<joint>.<interface>`. The message's own
/// header gives no column but the time of the row. Texts are not read.
class SchemaReader final : public messages::MessageReader {
 public:
  SchemaReader(MessageSchema schema, Serialization how);

  /// @return header.stamp in ns, where there is a header.
  /// @throw MessageError: it ends too early, an array has neither no elements nor as many as there
  ///        are names, or a name stands there twice.
  std::optional<std::int64_t> take_row(std::string_view message,
                                       messages::MessageColumns& columns) override;

 private:
  using Place = messages::MessageColumns::Place;
  using Names = std::vector<std::string_view>;

  std::optional<std::int64_t> take_stamp(CdrReader& message);
  void take_fields(CdrReader& message, const MessageType& type, std::size_t first, Place* place);
  void take_field(CdrReader& message, const MessageField& field, Place* place);
  void take_elements(CdrReader& message, const MessageField& field, std::size_t count,
                     Place* place);
  void take_named(CdrReader& message, const MessageField& field, const Names& names,
                  bool with_field, Place* parent, Place* place);
  static Names take_names(CdrReader& message);

  MessageSchema schema_;
  Serialization how_;
  bool has_header_;
  std::vector<bool> with_bytes_;         ///< By type: whether it takes any.
  messages::MessageColumns* columns_{};  ///< Of the row that is being read.
};

}  // namespace tribolog::ingest::bags
