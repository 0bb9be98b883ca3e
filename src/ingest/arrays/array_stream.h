#pragma once
// FileArrays from one process to another through a pipe.

#include <string>

#include "ingest/arrays/array_tables.h"

namespace tribolog {

/// @return false where the other end is closed.
bool send_arrays(int pipe, const FileArrays& found);
bool send_refusal(int pipe, const std::string& reason);

struct ReceivedArrays {
  bool is_complete{};   ///< Otherwise the sender ended too early, or sent what cannot be.
  std::string refusal;  ///< Empty: `found` holds what was sent.
  FileArrays found;
};
ReceivedArrays receive_arrays(int pipe);

}  // namespace tribolog
