#pragma once
// Handing an open file descriptor to the process at the other end of a local socket.

namespace tribolog::render {

/// Sends a duplicate of the descriptor; the caller keeps its own. False if the other side is gone.
bool send_descriptor(int socket, int descriptor);

/// Blocks until one arrives. The caller owns it; it is closed on exec. -1 if the other side is gone
/// or sent something else.
int receive_descriptor(int socket);

}  // namespace tribolog::render
