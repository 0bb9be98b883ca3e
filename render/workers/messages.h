#pragma once
// Messages between a process and its worker over a socket: a length, then that many bytes; and what
// is sent in them.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "render/figure/figure.h"

namespace tribolog::render::workers {

/// Writes values one after the other; reads them back in the same order.
class Message {
 public:
  void put(std::uint32_t value);
  void put(const std::string& text);
  void put(const std::vector<std::byte>& bytes);
  void put_raw(const void* from, std::size_t count);

  /// @throw tribolog::FigureError if the message ends before the value does.
  std::uint32_t take_number();
  std::string take_text();
  std::vector<std::byte> take_bytes();
  void take_raw(void* to, std::size_t count);

  [[nodiscard]] std::vector<std::byte>& bytes() { return bytes_; }
  [[nodiscard]] const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  const std::byte* next(std::size_t count);

  std::vector<std::byte> bytes_;
  std::size_t position_{0};
};

/// Blocks until all is sent. False if the other side is gone; never raises SIGPIPE.
bool send_message(int socket, const Message& message);

/// Blocks until a whole message is there; nothing if the other side is gone.
std::optional<Message> receive_message(int socket);

/// Collects a message from whatever has arrived, without blocking.
class MessageReader {
 public:
  enum class State { incomplete, complete, closed };
  State read_some(int socket);
  /// @pre the last state was complete. Starts over for the next message.
  Message take();

 private:
  std::vector<std::byte> received_;
};

// What a drawing process has to say, for the process that makes words of it.

void put_statement(Message& message, const Statement& statement);

/// @throw tribolog::FigureError if the message ends before the statement does, if what stands there
/// is no statement, or if it holds statements within statements more than eight deep.
Statement take_statement(Message& message);

// A figure's description, for the process that draws it.

void put_figure(Message& message, const figure::Figure& figure);

/// @throw tribolog::FigureError if the message ends before the figure does.
figure::Figure take_figure(Message& message);

}  // namespace tribolog::render::workers
