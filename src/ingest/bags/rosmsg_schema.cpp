#include "ingest/bags/rosmsg_schema.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"

namespace tribolog::ingest::bags {

std::optional<std::string_view> known_message_type(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 8> types = {{
      {"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"},
      {"builtin_interfaces/Duration", "int32 sec\nuint32 nanosec\n"},
      {"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"},
      {"std_msgs/Float64", "float64 data\n"},
      {"sensor_msgs/JointState",
       "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\n"
       "float64[] effort\n"},
      {"sensor_msgs/Temperature",
       "std_msgs/Header header\nfloat64 temperature\nfloat64 variance\n"},
      {"control_msgs/InterfaceValue", "string[] interface_names\nfloat64[] values\n"},
      {"control_msgs/DynamicJointState",
       "std_msgs/Header header\nstring[] joint_names\nInterfaceValue[] interface_values\n"},
  }};
  for (const auto& [type, text] : types) {
    if (type == name) return text;
  }
  return std::nullopt;
}

namespace {

constexpr std::size_t deepest_nesting = 32;
constexpr std::string_view blanks = " \t\r";

constexpr std::array<std::pair<std::string_view, Primitive>, 13> primitives = {{
    {"bool", Primitive::boolean},
    {"byte", Primitive::uint8},
    {"char", Primitive::uint8},
    {"int8", Primitive::int8},
    {"uint8", Primitive::uint8},
    {"int16", Primitive::int16},
    {"uint16", Primitive::uint16},
    {"int32", Primitive::int32},
    {"uint32", Primitive::uint32},
    {"int64", Primitive::int64},
    {"uint64", Primitive::uint64},
    {"float32", Primitive::float32},
    {"float64", Primitive::float64},
}};

/// Types of ROS 1 that no text defines.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> ros1_types = {{
    {"time", "uint32 sec\nuint32 nsec\n"},
    {"duration", "int32 sec\nint32 nsec\n"},
    {"std_msgs/Header", "uint32 seq\ntime stamp\nstring frame_id\n"},
}};

std::optional<std::string_view> known_ros1_type(std::string_view name) {
  for (const auto& [type, text] : ros1_types) {
    if (type == name) return text;
  }
  return std::nullopt;
}

enum class Dialect : std::uint8_t { ros1, ros2 };

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view take_word(std::string_view& text) {
  text = trimmed(text);
  const std::size_t end = std::min(text.find_first_of(blanks), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(end);
  return word;
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return trimmed(line);
}

bool is_separator(std::string_view line) {
  return line.size() >= 3 && line.find_first_not_of('=') == std::string_view::npos;
}

using TypeTexts = std::map<std::string, std::string_view, std::less<>>;

TypeTexts split_at_separators(std::string_view type, std::string_view text) {
  TypeTexts texts;
  std::string name = short_type_name(type);
  const char* start = text.data();
  for (std::string_view rest = text;;) {
    const char* const end = rest.data();
    const std::string_view line = take_line(rest);
    const bool is_end = rest.empty() && !is_separator(line);
    if (!is_end && !is_separator(line)) continue;
    const char* const stop = is_end ? text.data() + text.size() : end;
    texts.emplace(name, std::string_view(start, static_cast<std::size_t>(stop - start)));
    if (is_end || rest.empty()) return texts;
    std::string_view head = take_line(rest);
    if (!head.starts_with("MSG:")) {
      throw SchemaError(fmt::format("a line of = is followed by '{}', not by 'MSG: package/Type'",
                                    printable(std::string(head), 60)));
    }
    head.remove_prefix(4);
    name = short_type_name(trimmed(head));
    start = rest.data();
  }
}

class Parser {
 public:
  Parser(std::string_view type, std::string_view text, Dialect dialect)
      : dialect_(dialect), texts_(split_at_separators(type, text)) {
    (void)type_at(short_type_name(type), 0);
  }
  MessageSchema schema() && { return std::move(schema_); }

 private:
  /// Depth first; a type that is still being read when it is met again contains itself.
  std::size_t type_at(const std::string& name, std::size_t depth) {
    if (const auto known = places_.find(name); known != places_.end()) {
      if (!known->second.is_complete) throw SchemaError(name + " contains itself");
      return known->second.place;
    }
    if (depth > deepest_nesting) throw SchemaError(name + " is nested too deeply");
    const std::string_view text = text_of(name);
    const std::size_t place = schema_.types.size();
    schema_.types.push_back({name, {}});
    places_[name] = {place, false};
    std::size_t number = 0;
    for (std::string_view rest = text; !rest.empty();) {
      ++number;
      const std::string_view line = take_line(rest);
      if (line.empty() || line.starts_with('#')) continue;
      try {
        if (auto field = field_of(line, name, depth)) {
          schema_.types[place].fields.push_back(*std::move(field));
        }
      } catch (const BadLine& bad) {
        throw SchemaError(fmt::format("line {} of {}: {}", number, name, bad.why));
      }
    }
    places_[name].is_complete = true;
    return place;
  }

  struct BadLine {
    std::string why;
  };
  struct Place {
    std::size_t place{};
    bool is_complete{};
  };

  std::string_view text_of(const std::string& name) const {
    if (const auto text = texts_.find(name); text != texts_.end()) return text->second;
    const bool is_ros1 = dialect_ == Dialect::ros1;
    if (const auto text = is_ros1 ? known_ros1_type(name) : known_message_type(name)) return *text;
    throw SchemaError("type '" + printable(name, 60) + "' is not defined");
  }

  /// Nothing for a constant.
  std::optional<MessageField> field_of(std::string_view line, const std::string& inside,
                                       std::size_t depth) {
    const std::string_view type = take_word(line);
    line = trimmed(line);
    const std::size_t end = std::min(line.find_first_of(" \t\r=#"), line.size());
    MessageField field;
    field.name = line.substr(0, end);
    if (trimmed(line.substr(end)).starts_with('=')) return std::nullopt;
    if (field.name.empty()) {
      throw BadLine{"'" + printable(std::string(type), 60) + "' is no field: it has no name"};
    }
    const std::size_t bracket = std::min(type.find('['), type.size());
    read_count(type.substr(bracket), field);
    read_type(type.substr(0, bracket), field, inside, depth);
    return field;
  }

  static void read_count(std::string_view brackets, MessageField& field) {
    if (brackets.empty()) return;
    if (!brackets.ends_with(']')) throw BadLine{"a bracket is not closed"};
    const std::string_view count = brackets.substr(1, brackets.size() - 2);
    field.count = MessageField::Count::sequence;
    if (count.empty() || count.starts_with("<=")) return;
    field.count = MessageField::Count::fixed;
    const auto [rest, error] =
        std::from_chars(count.data(), count.data() + count.size(), field.elements);
    if (error != std::errc{} || rest != count.data() + count.size()) {
      throw BadLine{"'" + printable(std::string(count), 60) + "' is no number of elements"};
    }
  }

  void read_type(std::string_view type, MessageField& field, const std::string& inside,
                 std::size_t depth) {
    const auto* const primitive =
        std::find_if(primitives.begin(), primitives.end(),
                     [&](const auto& entry) { return entry.first == type; });
    if (primitive != primitives.end()) {
      const bool has_sign = dialect_ == Dialect::ros1 && type == "byte";
      field.primitive = has_sign ? Primitive::int8 : primitive->second;
      return;
    }
    if (type == "string" || type.starts_with("string<=")) {
      field.kind = MessageField::Kind::string;
      return;
    }
    if (type.starts_with("wstring")) throw BadLine{"wstring is not read"};
    field.kind = MessageField::Kind::message;
    field.type = type_at(full_name(type, inside), depth + 1);
  }

  [[nodiscard]] std::string full_name(std::string_view type, const std::string& inside) const {
    if (dialect_ == Dialect::ros1 && type == "Header") return "std_msgs/Header";
    const bool is_alone = dialect_ == Dialect::ros1 && known_ros1_type(type).has_value();
    if (is_alone || type.find('/') != std::string_view::npos) return short_type_name(type);
    return inside.substr(0, inside.find('/')) + "/" + std::string(type);
  }

  Dialect dialect_;
  TypeTexts texts_;
  MessageSchema schema_;
  std::map<std::string, Place> places_;
};

}  // namespace

std::string short_type_name(std::string_view type) {
  std::string name(type);
  if (const std::size_t middle = name.find("/msg/"); middle != std::string::npos) {
    name.erase(middle, 4);
  }
  return name;
}

MessageSchema parse_ros2msg(std::string_view type, std::string_view text) {
  return Parser(type, text, Dialect::ros2).schema();
}

MessageSchema parse_ros1msg(std::string_view type, std::string_view text) {
  return Parser(type, text, Dialect::ros1).schema();
}

}  // namespace tribolog::ingest::bags
