#include "ingest/manifest/urdf_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <expat.h>
#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "ingest/text/fields.h"
#include "wording/words.h"

namespace tribolog::ingest::manifest {
namespace {

constexpr std::size_t deepest_element = 64;
constexpr std::size_t most_elements = 200'000;
constexpr std::size_t most_links = 1000;
constexpr double farthest_from_parent_m = 100;  // more are millimetres
constexpr double heaviest_kg = 1e5;             // of a link: more are grams

// The document as elements with their places.

struct XmlElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::vector<XmlElement> children;
  Location where;

  [[nodiscard]] const XmlElement* child(const char* of_name) const {
    const auto it = std::find_if(children.begin(), children.end(),
                                 [&](const XmlElement& one) { return one.name == of_name; });
    return it == children.end() ? nullptr : &*it;
  }
};

/// Expat calls it from C: what it has to refuse is thrown when parsing has stopped.
class UrdfReader {
 public:
  explicit UrdfReader(const std::string& file) : file_(file), parser_(XML_ParserCreate(nullptr)) {
    if (!parser_) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), &UrdfReader::begin, &UrdfReader::end);
    XML_SetStartDoctypeDeclHandler(parser_.get(), &UrdfReader::refuse_document_type);
  }

  /// @return the root.
  XmlElement read(std::string_view text) {
    const XML_Status status =
        XML_Parse(parser_.get(), text.data(), static_cast<int>(text.size()), XML_TRUE);
    if (refusal_) throw InputError(refused_at_, *refusal_);
    if (status != XML_STATUS_OK) {
      throw InputError(
          here(), {"is no XML: " + std::string(XML_ErrorString(XML_GetErrorCode(parser_.get()))),
                   "", "a description of the arm in URDF", ""});
    }
    return std::move(above_.children.front());
  }

 private:
  [[nodiscard]] Location here() const {
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9  // which deprecates the others
    const auto line = XML_GetCurrentLineNumber64(parser_.get());
    const auto column = XML_GetCurrentColumnNumber64(parser_.get());
#else
    const auto line = XML_GetCurrentLineNumber(parser_.get());
    const auto column = XML_GetCurrentColumnNumber(parser_.get());
#endif
    return {file_, static_cast<long>(line), static_cast<long>(column) + 1};
  }

  void refuse(InputError::Problem problem) {
    if (refusal_) return;
    refusal_ = std::move(problem);
    refused_at_ = here();
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  static void begin(void* user, const XML_Char* name, const XML_Char** attributes) {
    auto& reader = *static_cast<UrdfReader*>(user);
    if (reader.refusal_) return;
    if (reader.open_.size() >= deepest_element || ++reader.elements_ > most_elements) {
      reader.refuse({"has too many elements", "",
                     fmt::format("at most {}, {} deep", most_elements, deepest_element), ""});
      return;
    }
    XmlElement element;
    element.name = name;
    element.where = reader.here();
    for (const XML_Char** one = attributes; *one != nullptr; one += 2) {
      element.attributes[one[0]] = one[1];
    }
    if (element.name.starts_with("xacro:")) {
      reader.refuse({"is xacro, which is not expanded", in_quotes(element.name), "URDF",
                     "xacro arm.urdf.xacro > arm.urdf"});
      return;
    }
    XmlElement& above = reader.open_.empty() ? reader.above_ : *reader.open_.back();
    above.children.push_back(std::move(element));
    // A parent gets no further child while one of its children is open: pointers stay.
    reader.open_.push_back(&above.children.back());
  }

  static void end(void* user, const XML_Char* /*name*/) {
    auto& reader = *static_cast<UrdfReader*>(user);
    if (!reader.refusal_ && !reader.open_.empty()) reader.open_.pop_back();
  }

  static void refuse_document_type(void* user, const XML_Char* /*name*/, const XML_Char* /*system*/,
                                   const XML_Char* /*is_public*/, int /*has_internal*/) {
    static_cast<UrdfReader*>(user)->refuse(
        {"has a document type", "<!DOCTYPE", "none: URDF needs no entities", ""});
  }

  struct Free {
    void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
  };

  const std::string& file_;
  std::unique_ptr<std::remove_pointer_t<XML_Parser>, Free> parser_;
  XmlElement above_;  ///< Of the root.
  std::vector<XmlElement*> open_;
  std::size_t elements_{};
  std::optional<InputError::Problem> refusal_;
  Location refused_at_;
};

// Attributes.

const std::string& attribute(const XmlElement& element, const char* name) {
  const auto found = element.attributes.find(name);
  if (found == element.attributes.end() || found->second.empty()) {
    throw InputError(element.where, {fmt::format("<{}> has no {}", printable(element.name), name),
                                     "", fmt::format("{}=\"...\"", name), ""});
  }
  return found->second;
}

[[noreturn]] void refuse_number(const XmlElement& element, const char* name,
                                const std::string& found, const std::string& expected) {
  throw InputError(element.where,
                   {fmt::format("<{}>: {} is not usable", printable(element.name), name),
                    in_quotes(found), expected, ""});
}

/// So many numbers with blanks between them.
std::vector<double> numbers(const XmlElement& element, const char* name, std::size_t count) {
  const std::string& stated = attribute(element, name);
  std::vector<double> found;
  constexpr std::string_view blanks = " \t\n\r";
  bool are_numbers = true;
  std::string_view left = stated;
  while (are_numbers && left.find_first_not_of(blanks) != std::string_view::npos) {
    left.remove_prefix(left.find_first_not_of(blanks));
    const std::string_view one = left.substr(0, left.find_first_of(blanks));
    const text::NumberField number = text::read_number(one);
    are_numbers = number.kind == text::FieldKind::number;
    found.push_back(number.value);
    left.remove_prefix(one.size());
  }
  if (!are_numbers || found.size() != count) {
    refuse_number(element, name, stated,
                  count == 1 ? "a number" : fmt::format("{} numbers", count));
  }
  return found;
}

Eigen::Vector3d point(const XmlElement& element, const char* name, const Eigen::Vector3d& none) {
  if (element.attributes.count(name) == 0) return none;
  const std::vector<double> xyz = numbers(element, name, 3);
  return {xyz[0], xyz[1], xyz[2]};
}

/// <origin xyz rpy>: turned about the fixed axes x, y, z, in this order.
Eigen::Isometry3d origin(const XmlElement& of) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  const XmlElement* element = of.child("origin");
  if (element == nullptr) return frame;
  const Eigen::Vector3d place_m = point(*element, "xyz", Eigen::Vector3d::Zero());
  if (place_m.cwiseAbs().maxCoeff() > farthest_from_parent_m) {
    throw InputError(
        element->where,
        {"<origin>: xyz is not usable", fmt::format("{}", place_m.cwiseAbs().maxCoeff()),
         fmt::format("at most {} m to each side", farthest_from_parent_m), "lengths are metres"});
  }
  const Eigen::Vector3d rpy = point(*element, "rpy", Eigen::Vector3d::Zero());
  frame.translate(place_m);
  frame.rotate(Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()));
  frame.rotate(Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()));
  frame.rotate(Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX()));
  return frame;
}

// Links and joints.

struct UrdfLink {
  const XmlElement* element{};
  double mass_kg{};
  Eigen::Vector3d centre_m{0, 0, 0};  ///< In the link's frame.
};

enum class UrdfMotion { turning, sliding, fixed };

struct UrdfJoint {
  const XmlElement* element{};
  std::string name;
  std::string parent;
  std::string child;
  UrdfMotion motion{};
  Eigen::Isometry3d origin{Eigen::Isometry3d::Identity()};
  Eigen::Vector3d axis{1, 0, 0};
};

UrdfLink read_link(const XmlElement& element) {
  UrdfLink link;
  link.element = &element;
  const XmlElement* inertial = element.child("inertial");
  if (inertial == nullptr) return link;
  const XmlElement* mass = inertial->child("mass");
  if (mass == nullptr) {
    throw InputError(inertial->where, {"<inertial> has no <mass>", "", "<mass value=\"...\"/>",
                                       "leave out <inertial> where a link has no mass"});
  }
  link.mass_kg = numbers(*mass, "value", 1).front();
  if (!(link.mass_kg >= 0) || link.mass_kg > heaviest_kg) {
    refuse_number(*mass, "value", attribute(*mass, "value"),
                  fmt::format("kilograms, from 0 to {:g}", heaviest_kg));
  }
  link.centre_m = origin(*inertial).translation();
  return link;
}

UrdfMotion motion_of(const XmlElement& joint) {
  const std::string& type = attribute(joint, "type");
  if (type == "revolute" || type == "continuous") return UrdfMotion::turning;
  if (type == "prismatic") return UrdfMotion::sliding;
  if (type == "fixed") return UrdfMotion::fixed;
  const std::string hint =
      type == "floating" || type == "planar" ? "an arm stands on its base" : "";
  throw InputError(joint.where, {"a joint's type is not usable", in_quotes(type),
                                 "revolute, continuous, prismatic or fixed", hint});
}

const std::string& link_named_in(const XmlElement& joint, const char* which) {
  const XmlElement* element = joint.child(which);
  if (element == nullptr) {
    throw InputError(joint.where, {fmt::format("<joint> has no <{}>", which), "",
                                   fmt::format("<{} link=\"...\"/>", which), ""});
  }
  return attribute(*element, "link");
}

UrdfJoint read_joint(const XmlElement& element) {
  UrdfJoint joint;
  joint.element = &element;
  joint.name = attribute(element, "name");
  joint.motion = motion_of(element);
  joint.parent = link_named_in(element, "parent");
  joint.child = link_named_in(element, "child");
  joint.origin = origin(element);
  if (const XmlElement* axis = element.child("axis")) {
    joint.axis = point(*axis, "xyz", joint.axis);
    const bool is_needed = joint.motion != UrdfMotion::fixed;
    if (is_needed && !(joint.axis.norm() > 0)) {
      refuse_number(*axis, "xyz", attribute(*axis, "xyz"), "a direction");
    }
  }
  return joint;
}

/// The arm, from the base on.
class ArmBuilder {
 public:
  explicit ArmBuilder(const XmlElement& robot) : robot_(robot) {
    for (const XmlElement& element : robot.children) {
      if (element.name == "link") add_link(element);
      if (element.name == "joint") add_joint(element);
    }
  }

  robot::WeightedArm build() {
    for (const UrdfJoint& joint : joints_) check_links(joint);
    carry(base(), {}, Eigen::Isometry3d::Identity());
    if (visited_ != links_.size()) refuse_ring();
    if (made_.empty()) {
      throw InputError(robot_.where, {"no joint moves", "", "a joint of type revolute", ""});
    }
    const bool has_mass = std::any_of(made_.begin(), made_.end(),
                                      [](const auto& joint) { return joint.mass_kg > 0; });
    if (!has_mass) {
      throw InputError(robot_.where, {"no link that moves has a mass", "",
                                      "<inertial><mass value=\"...\"/></inertial> in the links",
                                      "without masses gravity is not known"});
    }
    for (std::size_t k = 0; k < made_.size(); ++k) made_[k].follows = followed_by(*of_made_[k]);
    try {
      return robot::WeightedArm(std::move(made_));
    } catch (const std::invalid_argument& error) {
      throw InputError(robot_.where, {wording::words(error), "", "", ""});
    }
  }

 private:
  void add_link(const XmlElement& element) {
    const std::string& name = attribute(element, "name");
    if (!links_.emplace(name, read_link(element)).second) {
      throw InputError(element.where, {"two links have this name", in_quotes(name),
                                       "a name of its own for each", ""});
    }
    link_names_.push_back(name);
    if (link_names_.size() <= most_links) return;
    throw InputError(element.where,
                     {"the arm has too many links", "", fmt::format("at most {}", most_links), ""});
  }

  void add_joint(const XmlElement& element) {
    // In <transmission> or <gazebo> a joint is named only; those stand deeper.
    UrdfJoint joint = read_joint(element);
    for (const UrdfJoint& other : joints_) {
      if (other.name == joint.name) {
        throw InputError(element.where, {"two joints have this name", in_quotes(joint.name),
                                         "a name of its own for each", ""});
      }
      if (other.child == joint.child) {
        throw InputError(element.where, {"two joints carry one link", in_quotes(joint.child),
                                         "one joint for each link but the base",
                                         "a closed chain is no tree: cut it open"});
      }
    }
    joints_.push_back(std::move(joint));
  }

  void check_links(const UrdfJoint& joint) const {
    for (const std::string& link : {joint.parent, joint.child}) {
      if (links_.count(link) > 0) continue;
      throw InputError(joint.element->where,
                       {"there is no such link", in_quotes(link),
                        "one of " + list_of_names(link_names_), did_you_mean(link, link_names_)});
    }
  }

  /// The link that no joint carries.
  [[nodiscard]] const std::string& base() const {
    const std::string* found = nullptr;
    for (const std::string& name : link_names_) {
      const bool is_carried = std::any_of(joints_.begin(), joints_.end(),
                                          [&](const UrdfJoint& j) { return j.child == name; });
      if (is_carried) continue;
      if (found != nullptr) {
        throw InputError(links_.at(name).element->where,
                         {"a second link is carried by no joint", in_quotes(name),
                          "one base, here " + in_quotes(*found), ""});
      }
      found = &name;
    }
    if (found == nullptr) {
      throw InputError(robot_.where,
                       {links_.empty() ? "holds no link" : "each link is carried by another one",
                        "", "a base that no joint carries", ""});
    }
    return *found;
  }

  [[noreturn]] void refuse_ring() const {
    throw InputError(robot_.where,
                     {"links carry each other in a ring", "", "a tree from one base on", ""});
  }

  /// The link and all behind it. @param joint the last one before it that moves; absent: the base.
  /// @param frame of the link, in that joint's frame.
  void carry(const std::string& link, std::optional<std::size_t> joint,
             const Eigen::Isometry3d& frame) {
    ++visited_;
    if (joint) add_mass(links_.at(link), frame, made_[*joint]);
    for (const UrdfJoint& next : joints_) {
      if (next.parent != link) continue;
      const Eigen::Isometry3d at_zero = frame * next.origin;
      if (next.motion == UrdfMotion::fixed) {
        carry(next.child, joint, at_zero);
        continue;
      }
      robot::WeightedJoint moving;
      moving.name = next.name;
      moving.parent = joint;
      moving.at_zero = at_zero;
      moving.axis = next.axis;
      moving.motion = next.motion == UrdfMotion::turning ? robot::JointMotion::turning
                                                         : robot::JointMotion::sliding;
      made_.push_back(std::move(moving));
      of_made_.push_back(&next);
      carry(next.child, made_.size() - 1, Eigen::Isometry3d::Identity());
    }
  }

  static void add_mass(const UrdfLink& link, const Eigen::Isometry3d& frame,
                       robot::WeightedJoint& joint) {
    if (link.mass_kg == 0) return;
    const double sum_kg = joint.mass_kg + link.mass_kg;
    joint.centre_m =
        (joint.mass_kg * joint.centre_m + link.mass_kg * (frame * link.centre_m)) / sum_kg;
    joint.mass_kg = sum_kg;
  }

  [[nodiscard]] std::optional<robot::FollowedJoint> followed_by(const UrdfJoint& joint) const {
    const XmlElement* mimic = joint.element->child("mimic");
    if (mimic == nullptr) return std::nullopt;
    const std::string& name = attribute(*mimic, "joint");
    std::vector<std::string> names;
    for (const UrdfJoint* one : of_made_) names.push_back(one->name);
    const auto it = std::find(names.begin(), names.end(), name);
    if (it == names.end() || name == joint.name) {
      throw InputError(mimic->where, {"there is no such joint to follow", in_quotes(name),
                                      "one of " + list_of_names(names), did_you_mean(name, names)});
    }
    robot::FollowedJoint followed;
    followed.joint = static_cast<std::size_t>(it - names.begin());
    const auto number_or = [&](const char* key, double otherwise) {
      return mimic->attributes.count(key) > 0 ? numbers(*mimic, key, 1).front() : otherwise;
    };
    followed.factor = number_or("multiplier", 1);
    followed.offset = number_or("offset", 0);
    return followed;
  }

  const XmlElement& robot_;
  std::map<std::string, UrdfLink> links_;
  std::vector<std::string> link_names_;
  std::vector<UrdfJoint> joints_;
  std::vector<robot::WeightedJoint> made_;
  std::vector<const UrdfJoint*> of_made_;  ///< One for each that was made.
  std::size_t visited_{};
};

}  // namespace

bool is_urdf(const std::string& file) { return file.ends_with(".urdf"); }

robot::WeightedArm parse_urdf(std::string_view text, const std::string& file) {
  const XmlElement robot = UrdfReader(file).read(text);
  if (robot.name != "robot") {
    throw InputError(
        robot.where,
        {"is no URDF", "<" + printable(robot.name) + ">", "<robot>",
         robot.name == "mujoco" || robot.name == "sdf" ? "export the model as URDF" : ""});
  }
  return ArmBuilder(robot).build();
}

}  // namespace tribolog::ingest::manifest
