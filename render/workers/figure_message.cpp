#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "render/workers/messages.h"

namespace tribolog::render::workers {
namespace {

template <class Item, class Type>
concept Is = std::same_as<std::remove_const_t<Item>, Type>;

// One list of fields for both directions: `Visitor` is Writer or Reader.

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::Colour> auto& item) {
  visit(item.red, item.green, item.blue, item.alpha);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::Series> auto& item) {
  visit(item.label, item.x, item.y, item.colour, item.width_px, item.style, item.marker,
        item.marker_size_px, item.direction_arrows_at, item.is_marked_at_edge);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::Band> auto& item) {
  visit(item.label, item.x, item.low, item.high, item.colour);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::ErrorBar> auto& item) {
  visit(item.x, item.low, item.high, item.colour);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::PointLabel> auto& item) {
  visit(item.x, item.y, item.text, item.colour, item.marker);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::ReferenceLine> auto& item) {
  visit(item.direction, item.at, item.text, item.colour, item.style);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::AxisName> auto& item) {
  visit(item.at, item.text);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::Axis> auto& item) {
  visit(item.title, item.minimum, item.maximum, item.logarithmic, item.dates, item.counts,
        item.names);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::Panel> auto& item) {
  visit(item.title, item.x, item.y, item.bands, item.series, item.error_bars, item.point_labels,
        item.reference_lines, item.show_legend, item.notice);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::DiagramPoint> auto& item) {
  visit(item.x, item.y);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::PortSign> auto& item) {
  visit(item.side, item.offset, item.text);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::Block> auto& item) {
  visit(item.kind, item.lines, item.centre, item.width, item.height, item.faces, item.signs,
        item.colour, item.fill);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::DiagramText> auto& item) {
  visit(item.text, item.at, item.place, item.bold, item.colour);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::Wire> auto& item) {
  visit(item.points, item.arrow, item.branch_dots, item.label, item.colour);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::Stroke> auto& item) {
  visit(item.points, item.colour, item.width_px, item.style, item.arrow_at_start,
        item.arrow_at_end);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::Area> auto& item) {
  visit(item.outline, item.colour);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::Arc> auto& item) {
  visit(item.centre, item.radius, item.from_deg, item.to_deg, item.colour, item.width_px,
        item.arrow_at_end, item.fill);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::Dimension> auto& item) {
  visit(item.from, item.to, item.text, item.place, item.colour);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::Diagram> auto& item) {
  visit(item.width, item.height, item.areas, item.blocks, item.wires, item.strokes, item.arcs,
        item.dimensions, item.texts);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::Point3> auto& item) {
  visit(item.x, item.y, item.z);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::SceneBody> auto& item) {
  visit(item.label, item.from, item.to, item.from_radius_m, item.to_radius_m, item.colour,
        item.thickness_m, item.normal);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::SceneDrum> auto& item) {
  visit(item.label, item.centre, item.axis, item.radius_m, item.length_m, item.colour);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::SceneArrow> auto& item) {
  visit(item.label, item.from, item.to, item.radius_m, item.colour);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::SceneBall> auto& item) {
  visit(item.label, item.centre, item.radius_m, item.colour, item.inside);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::SceneSector> auto& item) {
  visit(item.label, item.centre, item.normal, item.zero, item.radius_m, item.from_rad, item.to_rad,
        item.colour, item.filled, item.fill, item.ends);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::SceneDimension> auto& item) {
  visit(item.label, item.from, item.to, item.shift, item.colour);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::SceneLine> auto& item) {
  visit(item.label, item.points, item.colour, item.width_px, item.style);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::SceneText> auto& item) {
  visit(item.text, item.at, item.colour);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::SceneGround> auto& item) {
  visit(item.centre, item.half_size_m, item.spacing_m);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::SceneCamera> auto& item) {
  visit(item.towards, item.up, item.opening_deg, item.margin, item.fit);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::Scene> auto& item) {
  visit(item.camera, item.ground, item.bodies, item.drums, item.arrows, item.balls, item.sectors,
        item.dimensions, item.lines, item.texts);
}

template <class Visitor>
void visit_fields(Visitor& visit, Is<figure::Figure> auto& item) {
  visit(item.id, item.title, item.panels, item.diagram, item.scene, item.width_px, item.height_px,
        item.panels_share_x, item.width_mm, item.look);
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
