#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "render/workers/messages.h"

namespace tribolog::render::workers {

/// Stands for a value of any type where a structure is counted, and is never made.
struct AnyValue {
  template <class Type>
  operator Type() const;  // NOLINT
};

namespace {

template <class Item, class... Values>
consteval std::size_t count_of_fields() {
  if constexpr (requires { Item{Values{}..., AnyValue{}}; }) {
    return count_of_fields<Item, Values..., AnyValue>();
  } else {
    return sizeof...(Values);
  }
}

/// All fields of a structure of figure.h, in their order: `Visitor` is Writer or Reader.
template <class Visitor, class Item>
void visit_fields(Visitor& visit, Item& item) {
  static_assert(std::is_aggregate_v<Item>);
  constexpr std::size_t count = count_of_fields<std::remove_const_t<Item>>();
  static_assert(count > 1 && count < 12);
  if constexpr (count == 2) {
    auto& [a, b] = item;
    visit(a, b);
  } else if constexpr (count == 3) {
    auto& [a, b, c] = item;
    visit(a, b, c);
  } else if constexpr (count == 4) {
    auto& [a, b, c, d] = item;
    visit(a, b, c, d);
  } else if constexpr (count == 5) {
    auto& [a, b, c, d, e] = item;
    visit(a, b, c, d, e);
  } else if constexpr (count == 6) {
    auto& [a, b, c, d, e, f] = item;
    visit(a, b, c, d, e, f);
  } else if constexpr (count == 7) {
    auto& [a, b, c, d, e, f, g] = item;
    visit(a, b, c, d, e, f, g);
  } else if constexpr (count == 8) {
    auto& [a, b, c, d, e, f, g, h] = item;
    visit(a, b, c, d, e, f, g, h);
  } else if constexpr (count == 9) {
    auto& [a, b, c, d, e, f, g, h, i] = item;
    visit(a, b, c, d, e, f, g, h, i);
  } else if constexpr (count == 10) {
    auto& [a, b, c, d, e, f, g, h, i, j] = item;
    visit(a, b, c, d, e, f, g, h, i, j);
  } else if constexpr (count == 11) {
    auto& [a, b, c, d, e, f, g, h, i, j, k] = item;
    visit(a, b, c, d, e, f, g, h, i, j, k);
  }
}

template <class Value>
constexpr bool is_plain = std::is_arithmetic_v<Value> || std::is_enum_v<Value>;

class Writer {
 public:
  explicit Writer(Message& message) : message_(message) {}

  template <class... Values>
  void operator()(const Values&... values) {
    (put(values), ...);
  }

 private:
  void put(const std::string& text) { message_.put(text); }
  template <class Value>
  void put(const std::optional<Value>& value) {
    put(value.has_value());
    if (value) put(*value);
  }
  template <class Value>
  void put(const std::vector<Value>& values) {
    message_.put(static_cast<std::uint32_t>(values.size()));
    if constexpr (is_plain<Value>) {
      message_.put_raw(values.data(), values.size() * sizeof(Value));
    } else {
      for (const Value& value : values) put(value);
    }
  }
  template <class Value>
  void put(const Value& value) {
    if constexpr (is_plain<Value>) {
      message_.put_raw(&value, sizeof value);
    } else {
      visit_fields(*this, value);
    }
  }

  Message& message_;
};

class Reader {
 public:
  explicit Reader(Message& message) : message_(message) {}

  template <class... Values>
  void operator()(Values&... values) {
    (take(values), ...);
  }

 private:
  void take(std::string& text) { text = message_.take_text(); }
  template <class Value>
  void take(std::optional<Value>& value) {
    bool present = false;
    take(present);
    if (present) take(value.emplace());
  }
  template <class Value>
  void take(std::vector<Value>& values) {
    values.resize(message_.take_number());
    if constexpr (is_plain<Value>) {
      message_.take_raw(values.data(), values.size() * sizeof(Value));
    } else {
      for (Value& value : values) take(value);
    }
  }
  template <class Value>
  void take(Value& value) {
    if constexpr (is_plain<Value>) {
      message_.take_raw(&value, sizeof value);
    } else {
      visit_fields(*this, value);
    }
  }

  Message& message_;
};

}  // namespace

void put_figure(Message& message, const figure::Figure& figure) {
  Writer write(message);
  write(figure);
}

figure::Figure take_figure(Message& message) {
  figure::Figure figure;
  Reader read(message);
  read(figure);
  return figure;
}

}  // namespace tribolog::render::workers
