#include "render/workers/message_channel.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

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

}  // namespace tribolog::render::workers
