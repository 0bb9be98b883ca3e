#include "render/workers/messages.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <sys/socket.h>
#include <unistd.h>

#include "base/error.h"

namespace tribolog::render::workers {
namespace {

constexpr std::size_t length_bytes = sizeof(std::uint32_t);
constexpr std::size_t largest_message = std::size_t{1} << 30U;

std::size_t announced_length(const std::vector<std::byte>& bytes) {
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data(), length_bytes);
  return length;
}

bool send_all(int socket, const std::byte* data, std::size_t count) {
  while (count > 0) {
    const ssize_t sent = send(socket, data, count, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    data += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool receive_all(int socket, std::byte* data, std::size_t count) {
  while (count > 0) {
    const ssize_t got = recv(socket, data, count, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    data += got;
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

}  // namespace

void Message::put_raw(const void* from, std::size_t count) {
  const auto* bytes = static_cast<const std::byte*>(from);
  bytes_.insert(bytes_.end(), bytes, bytes + count);
}

void Message::put(std::uint32_t value) { put_raw(&value, sizeof value); }

void Message::put(const std::string& text) {
  put(static_cast<std::uint32_t>(text.size()));
  put_raw(text.data(), text.size());
}

void Message::put(const std::vector<std::byte>& bytes) {
  put(static_cast<std::uint32_t>(bytes.size()));
  put_raw(bytes.data(), bytes.size());
}

const std::byte* Message::next(std::size_t count) {
  if (bytes_.size() - position_ < count) throw FigureError({"drawing.message_ends_early"});
  const std::byte* at = bytes_.data() + position_;
  position_ += count;
  return at;
}

void Message::take_raw(void* to, std::size_t count) {
  const std::byte* from = next(count);
  if (count > 0) std::memcpy(to, from, count);
}

std::uint32_t Message::take_number() {
  std::uint32_t value = 0;
  take_raw(&value, sizeof value);
  return value;
}

std::string Message::take_text() {
  const std::size_t size = take_number();
  return {reinterpret_cast<const char*>(next(size)), size};
}

std::vector<std::byte> Message::take_bytes() {
  const std::size_t size = take_number();
  const std::byte* from = next(size);
  return {from, from + size};
}

bool send_message(int socket, const Message& message) {
  const auto length = static_cast<std::uint32_t>(message.bytes().size());
  return send_all(socket, reinterpret_cast<const std::byte*>(&length), sizeof length) &&
         send_all(socket, message.bytes().data(), message.bytes().size());
}

std::optional<Message> receive_message(int socket) {
  std::uint32_t length = 0;
  if (!receive_all(socket, reinterpret_cast<std::byte*>(&length), sizeof length)) return {};
  if (length > largest_message) return {};
  Message message;
  message.bytes().resize(length);
  if (!receive_all(socket, message.bytes().data(), length)) return {};
  return message;
}

MessageReader::State MessageReader::read_some(int socket) {
  std::array<std::byte, 1U << 16U> buffer{};
  ssize_t got = 0;
  do {
    got = recv(socket, buffer.data(), buffer.size(), MSG_DONTWAIT);
  } while (got < 0 && errno == EINTR);
  if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return State::incomplete;
  if (got <= 0) return State::closed;
  received_.insert(received_.end(), buffer.begin(), buffer.begin() + got);
  if (received_.size() < length_bytes) return State::incomplete;
  const std::size_t length = announced_length(received_);
  if (length > largest_message) return State::closed;
  return received_.size() >= length_bytes + length ? State::complete : State::incomplete;
}

Message MessageReader::take() {
  const auto end = static_cast<std::ptrdiff_t>(length_bytes + announced_length(received_));
  Message message;
  message.bytes().assign(received_.begin() + static_cast<std::ptrdiff_t>(length_bytes),
                         received_.begin() + end);
  received_.erase(received_.begin(), received_.begin() + end);
  return message;
}

// Statements.

namespace {

constexpr int deepest = 8;
constexpr std::size_t longest_code = 100;

/// As the alternatives of StatedValue::Value.
enum Kind : std::uint32_t { number_kind, count_kind, text_kind, statements_kind };

template <class Value>
Value take_plain(Message& message) {
  Value value{};
  message.take_raw(&value, sizeof value);
  return value;
}

Code take_code(Message& message) {
  const std::string text = message.take_text();
  const bool is_one =
      text.size() <= longest_code && std::all_of(text.begin(), text.end(), [](unsigned char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '.';
      });
  // What is no code must not be kept as one.
  if (!is_one) throw FigureError({"drawing.message_damaged"});
  return text.empty() ? Code() : Code::of(text);
}

Statement take(Message& message, int depth);

StatedValue::Value take_value(Message& message, int depth) {
  switch (message.take_number()) {
    case number_kind:
      return take_plain<double>(message);
    case count_kind:
      return take_plain<std::int64_t>(message);
    case text_kind:
      return message.take_text();
    case statements_kind: {
      std::vector<Statement> inner;
      const std::uint32_t count = message.take_number();
      for (std::uint32_t i = 0; i < count; ++i) inner.push_back(take(message, depth + 1));
      return inner;
    }
    default:
      throw FigureError({"drawing.message_damaged"});
  }
}

Statement take(Message& message, int depth) {
  if (depth > deepest) throw FigureError({"drawing.message_damaged"});
  const Code code = take_code(message);
  std::vector<StatedValue> values;
  const std::uint32_t count = message.take_number();
  for (std::uint32_t i = 0; i < count; ++i) {
    StatedValue one(message.take_text(), std::string());
    one.value = take_value(message, depth);
    values.push_back(std::move(one));
  }
  return Statement::with(code, std::move(values));
}

}  // namespace

void put_statement(Message& message, const Statement& statement) {
  message.put(std::string(statement.code().text()));
  message.put(static_cast<std::uint32_t>(statement.values().size()));
  for (const StatedValue& one : statement.values()) {
    message.put(one.name);
    message.put(static_cast<std::uint32_t>(one.value.index()));
    if (const auto* number = std::get_if<double>(&one.value)) {
      message.put_raw(number, sizeof *number);
    } else if (const auto* count = std::get_if<std::int64_t>(&one.value)) {
      message.put_raw(count, sizeof *count);
    } else if (const auto* text = std::get_if<std::string>(&one.value)) {
      message.put(*text);
    } else {
      const auto& inner = std::get<std::vector<Statement>>(one.value);
      message.put(static_cast<std::uint32_t>(inner.size()));
      for (const Statement& part : inner) put_statement(message, part);
    }
  }
}

Statement take_statement(Message& message) { return take(message, 0); }

}  // namespace tribolog::render::workers
