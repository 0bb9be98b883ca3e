#include "ingest/arrays/array_stream.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>

#include <unistd.h>

namespace tribolog {
namespace {

constexpr std::uint8_t arrays_follow = 1;
constexpr std::uint8_t refusal_follows = 2;
/// The sender may have gone mad: more is not believed.
constexpr std::uint64_t longest_text = std::uint64_t{1} << 20;
constexpr std::uint64_t most_entries = std::uint64_t{1} << 20;

class Sender {
 public:
  explicit Sender(int pipe) : pipe_(pipe) {}

  void bytes(const void* data, std::size_t count) {
    const char* next = static_cast<const char*>(data);
    while (ok_ && count > 0) {
      const ssize_t done = ::write(pipe_, next, count);
      if (done < 0 && errno == EINTR) continue;
      ok_ = done > 0;
      if (!ok_) return;
      next += done;
      count -= static_cast<std::size_t>(done);
    }
  }
  void number(std::uint64_t value) { bytes(&value, sizeof value); }
  void text(const std::string& value) {
    const std::uint64_t length = std::min<std::uint64_t>(value.size(), longest_text);
    number(length);
    bytes(value.data(), length);
  }
  [[nodiscard]] bool ok() const { return ok_; }

 private:
  int pipe_;
  bool ok_{true};
};

class Receiver {
 public:
  explicit Receiver(int pipe) : pipe_(pipe) {}

  void bytes(void* data, std::size_t count) {
    char* next = static_cast<char*>(data);
    while (ok_ && count > 0) {
      const ssize_t done = ::read(pipe_, next, count);
      if (done < 0 && errno == EINTR) continue;
      ok_ = done > 0;
      if (!ok_) return;
      next += done;
      count -= static_cast<std::size_t>(done);
    }
  }
  std::uint64_t number(std::uint64_t largest) {
    std::uint64_t value{};
    bytes(&value, sizeof value);
    ok_ = ok_ && value <= largest;
    return ok_ ? value : 0;
  }
  std::string text() {
    std::string value(number(longest_text), '\0');
    bytes(value.data(), value.size());
    return value;
  }
  NamedArray array(std::uint64_t& values_left) {
    NamedArray result;
    result.name = text();
    result.unit = text();
    result.rows = number(most_values);
    result.columns = number(most_values);
    result.by_columns = number(1) == 1;
    result.was_rounded = number(1) == 1;
    const std::uint64_t count = number(values_left);
    ok_ = ok_ && count > 0 && result.rows > 0 && count / result.rows == result.columns &&
          count % result.rows == 0;
    if (!ok_) return result;
    values_left -= count;
    result.values.resize(count);
    bytes(result.values.data(), count * sizeof(double));
    return result;
  }
  [[nodiscard]] bool ok() const { return ok_; }

 private:
  int pipe_;
  bool ok_{true};
};

using Pairs = std::vector<std::pair<std::string, std::string>>;

void send_pairs(Sender& sender, const Pairs& pairs) {
  sender.number(pairs.size());
  for (const auto& [name, text] : pairs) {
    sender.text(name);
    sender.text(text);
  }
}

Pairs receive_pairs(Receiver& receiver) {
  Pairs pairs;
  const std::uint64_t count = receiver.number(most_entries);
  for (std::uint64_t i = 0; i < count && receiver.ok(); ++i) {
    std::string name = receiver.text();
    pairs.emplace_back(std::move(name), receiver.text());
  }
  return pairs;
}

}  // namespace

bool send_arrays(int pipe, const FileArrays& found) {
  Sender sender(pipe);
  sender.bytes(&arrays_follow, 1);
  sender.number(found.arrays.size());
  for (const NamedArray& array : found.arrays) {
    sender.text(array.name);
    sender.text(array.unit);
    sender.number(array.rows);
    sender.number(array.columns);
    sender.number(array.by_columns ? 1 : 0);
    sender.number(array.was_rounded ? 1 : 0);
    sender.number(array.values.size());
    sender.bytes(array.values.data(), array.values.size() * sizeof(double));
  }
  send_pairs(sender, found.texts);
  send_pairs(sender, found.left_out);
  return sender.ok();
}

bool send_refusal(int pipe, const std::string& reason) {
  Sender sender(pipe);
  sender.bytes(&refusal_follows, 1);
  sender.text(reason);
  return sender.ok();
}

ReceivedArrays receive_arrays(int pipe) {
  Receiver receiver(pipe);
  ReceivedArrays received;
  std::uint8_t kind{};
  receiver.bytes(&kind, 1);
  if (kind == refusal_follows) {
    received.refusal = receiver.text();
  } else if (kind == arrays_follow) {
    std::uint64_t values_left = most_values;
    const std::uint64_t count = receiver.number(most_entries);
    for (std::uint64_t i = 0; i < count && receiver.ok(); ++i) {
      received.found.arrays.push_back(receiver.array(values_left));
    }
    received.found.texts = receive_pairs(receiver);
    received.found.left_out = receive_pairs(receiver);
  }
  received.is_complete = receiver.ok() && (kind == arrays_follow || !received.refusal.empty());
  return received;
}

}  // namespace tribolog
