#pragma once
// The one place that writes to standard output.

#include <string_view>

namespace tribolog {

/// The three standard streams are open from here on: where one was closed, no file that is opened
/// later takes its place, and writing to it fails. To be called before anything is opened.
void keep_standard_streams_open();

/// Writes at once. A failure is remembered, and nothing is printed any more; a reader that goes
/// away
/// (| head) is none.
void print(std::string_view bytes);

/// Everything printed has arrived. @throw OutputError with the system's reason.
void finish_printing();

}  // namespace tribolog
