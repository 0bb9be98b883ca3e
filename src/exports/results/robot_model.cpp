#include "exports/results/robot_model.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <string_view>

#include <expat.h>
#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "exports/results/simulator_numbers.h"

namespace tribolog::exports::results {
namespace {

/// Bytes of the model, from `first` up to `last`.
struct Stretch {
  std::size_t first{};
  std::size_t last{};
  [[nodiscard]] bool empty() const { return first == last; }
};

/// An element with what stands between its tags.
struct Element {
  Stretch tag;  ///< The start tag; of an element without an end tag the whole of it.
  Stretch content;
  [[nodiscard]] bool has_end_tag() const { return content.first != 0; }
};

/// The joint, and what it has of the elements that hold friction.
struct FoundJoint {
  Location where;
  std::string type;
  std::optional<Element> joint, axis, dynamics, damping, friction;
};

bool slides_or_rests(const std::string& type) {
  return type == "fixed" || type == "prismatic" || type == "slide" || type == "planar" ||
         type == "floating" || type == "free" || type == "ball";
}

/// Finds the joint of a name by the format that the root element says. Expat calls it from C: what
/// it has to refuse is thrown when parsing has stopped.
class ModelReader {
 public:
  ModelReader(const std::string& file, const std::string& name)
      : file_(file), name_(name), parser_(XML_ParserCreate(nullptr)) {
    if (!parser_) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), &ModelReader::begin, &ModelReader::end);
    XML_SetStartDoctypeDeclHandler(parser_.get(), &ModelReader::refuse_document_type);
  }

  FoundJoint read(const std::string& text) {
    const XML_Status status =
        XML_Parse(parser_.get(), text.data(), static_cast<int>(text.size()), XML_TRUE);
    if (refusal_) throw InputError(refused_at_, *refusal_);
    if (status != XML_STATUS_OK) {
      throw InputError(
          here(), {"is no XML: " + std::string(XML_ErrorString(XML_GetErrorCode(parser_.get()))),
                   "", "a robot's model: URDF, SDF or MJCF", ""});
    }
    if (!found_.joint) {
      throw InputError({file_}, {"has no joint of this name", in_quotes(name_),
                                 names_.empty() ? "a joint" : "one of " + list_of_names(names_),
                                 "--joint says which it is in the model"});
    }
    return found_;
  }

  [[nodiscard]] const std::string& format() const { return format_; }

 private:
  [[nodiscard]] Location here() const {
    return {file_, static_cast<long>(XML_GetCurrentLineNumber(parser_.get())),
            static_cast<long>(XML_GetCurrentColumnNumber(parser_.get())) + 1};
  }

  [[nodiscard]] Stretch tag_here() const {
    const auto first = static_cast<std::size_t>(XML_GetCurrentByteIndex(parser_.get()));
    return {first, first + static_cast<std::size_t>(XML_GetCurrentByteCount(parser_.get()))};
  }

  void refuse(InputError::Problem problem) {
    if (refusal_) return;
    refusal_ = std::move(problem);
    refused_at_ = here();
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  static const char* attribute(const XML_Char** attributes, const char* name) {
    for (const XML_Char** one = attributes; *one != nullptr; one += 2) {
      if (std::strcmp(one[0], name) == 0) return one[1];
    }
    return nullptr;
  }

  static void begin(void* user, const XML_Char* name, const XML_Char** attributes) {
    static_cast<ModelReader*>(user)->begin_element(name, attributes);
  }

  void begin_element(const std::string& name, const XML_Char** attributes) {
    if (refusal_) return;
    if (path_.empty()) {
      format_ = name == "robot" ? "URDF" : name == "sdf" ? "SDF" : name == "mujoco" ? "MJCF" : "";
      if (format_.empty()) {
        refuse({"is no model of a robot", "<" + name + ">",
                "URDF (<robot>), SDF (<sdf>) or MJCF "
                "(<mujoco>)",
                ""});
      }
    }
    path_.push_back(name);
    if (name == "joint" && is_joint_of_the_robot()) begin_joint(attributes);
    if (!is_inside_) return;
    if (std::optional<Element>* const part = part_of_joint()) {
      if (!*part) *part = Element{tag_here(), {}};
    }
  }

  /// In MJCF other elements hold references called joint.
  [[nodiscard]] bool is_joint_of_the_robot() const {
    if (format_ == "URDF") return path_.size() == 2;
    const char* const above = format_ == "SDF" ? "model" : "body";
    return path_.size() > 2 && path_[path_.size() - 2] == above;
  }

  void begin_joint(const XML_Char** attributes) {
    const char* const name = attribute(attributes, "name");
    if (name == nullptr) return;
    names_.emplace_back(name);
    if (name != name_) return;
    if (found_.joint) {
      refuse({"has two joints of this name", in_quotes(name_), "one", ""});
      return;
    }
    const char* const type = attribute(attributes, "type");
    found_.type = type == nullptr ? "" : type;
    if (slides_or_rests(found_.type)) {
      refuse({"has another kind of joint of this name", found_.type, "a joint that turns", ""});
      return;
    }
    found_.where = here();
    is_inside_ = true;
    depth_ = path_.size();
  }

  /// The part of the joint that the path ends with; nullptr: none.
  std::optional<Element>* part_of_joint() {
    const std::size_t below = path_.size() - depth_;
    const auto is = [&](std::initializer_list<const char*> names) {
      return below == names.size() &&
             std::equal(names.begin(), names.end(),
                        path_.begin() + static_cast<std::ptrdiff_t>(depth_));
    };
    if (below == 0) return &found_.joint;
    if (format_ == "URDF") return is({"dynamics"}) ? &found_.dynamics : nullptr;
    if (format_ != "SDF") return nullptr;
    if (is({"axis"})) return &found_.axis;
    if (is({"axis", "dynamics"})) return &found_.dynamics;
    if (is({"axis", "dynamics", "damping"})) return &found_.damping;
    if (is({"axis", "dynamics", "friction"})) return &found_.friction;
    return nullptr;
  }

  static void end(void* user, const XML_Char* /*name*/) {
    static_cast<ModelReader*>(user)->end_element();
  }

  void end_element() {
    if (refusal_ || path_.empty()) return;
    if (is_inside_) {
      std::optional<Element>* const part = part_of_joint();
      const Stretch tag = tag_here();  // empty for an element without an end tag
      if (part != nullptr && *part && !(*part)->has_end_tag() && !tag.empty()) {
        (*part)->content = {(*part)->tag.last, tag.first};
      }
      if (path_.size() == depth_) is_inside_ = false;
    }
    path_.pop_back();
  }

  static void refuse_document_type(void* user, const XML_Char* /*name*/, const XML_Char* /*system*/,
                                   const XML_Char* /*is_public*/, int /*has_internal*/) {
    static_cast<ModelReader*>(user)->refuse(
        {"has a document type", "<!DOCTYPE", "none: its entities could stand for anything", ""});
  }

  struct Free {
    void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
  };

  const std::string& file_;
  const std::string& name_;
  std::unique_ptr<std::remove_pointer_t<XML_Parser>, Free> parser_;
  std::string format_;
  std::vector<std::string> path_;
  std::vector<std::string> names_;
  FoundJoint found_;
  bool is_inside_{};
  std::size_t depth_{};  ///< Of the joint.
  std::optional<InputError::Problem> refusal_;
  Location refused_at_;
};

struct Edit {
  Stretch old;
  std::string text;
};

/// Where the value of an attribute stands between its quotes, within the tag; empty: it has none.
Stretch value_of(std::string_view tag, std::string_view name) {
  std::size_t at = 1;
  const auto is_blank = [&] { return std::strchr(" \t\r\n", tag[at]) != nullptr; };
  while (at < tag.size() && !is_blank() && tag[at] != '>' && tag[at] != '/') ++at;
  while (at < tag.size()) {
    while (at < tag.size() && is_blank()) ++at;
    const std::size_t begin = at;
    while (at < tag.size() && tag[at] != '=' && !is_blank() && tag[at] != '>') ++at;
    const std::string_view found = tag.substr(begin, at - begin);
    const std::size_t open = tag.find_first_of("\"'>", at);
    if (open == std::string_view::npos || tag[open] == '>') break;
    const std::size_t close = tag.find(tag[open], open + 1);
    if (close == std::string_view::npos) break;
    if (found == name) return {open + 1, close};
    at = close + 1;
  }
  return {};
}

/// Behind the last attribute of a tag.
std::size_t end_of_attributes(std::string_view tag) {
  std::size_t end = tag.size() - 1;
  if (end > 0 && tag[end - 1] == '/') --end;
  while (end > 1 && std::strchr(" \t\r\n", tag[end - 1]) != nullptr) --end;
  return end;
}

/// Makes the edits of one joint.
class JointEditor {
 public:
  JointEditor(const std::string& model, PatchedModel& made) : model_(model), made_(made) {}

  void set_attribute(const Element& element, const std::string& name, double value) {
    const std::string_view tag = text_of(element.tag);
    const Stretch old = value_of(tag, name);
    if (old.first == 0) {
      add_attribute(element, name, shortest(value));
    } else {
      change({element.tag.first + old.first, element.tag.first + old.last}, shortest(value), name,
             std::string(tag.substr(old.first, old.last - old.first)), value);
    }
  }

  /// Of a model that says nothing of it.
  void add_attribute(const Element& element, const std::string& name, const std::string& value) {
    const std::string_view tag = text_of(element.tag);
    if (value_of(tag, name).first != 0) return;
    const std::size_t at = element.tag.first + end_of_attributes(tag);
    edits_.push_back({{at, at}, fmt::format(" {}=\"{}\"", name, value)});
    made_.changes.push_back(fmt::format("{}: none -> {}", name, value));
  }

  void set_content(const Element& element, const std::string& name, double value) {
    if (!element.has_end_tag()) {
      change(element.tag, fmt::format("<{0}>{1}</{0}>", name, shortest(value)), name, "none",
             value);
    } else {
      change(element.content, shortest(value), name, std::string(text_of(element.content)), value);
    }
  }

  /// A new element in front of the others. @param body what stands there, without indentation.
  void add_child(const Element& parent, const std::string& parent_name, const std::string& body) {
    if (!parent.has_end_tag()) {
      std::string tag(text_of(parent.tag));
      tag.erase(tag.rfind('/'), 1);
      edits_.push_back({parent.tag, tag + body + "</" + parent_name + ">"});
      return;
    }
    // The blanks in front of its first child stand in front of the new one too.
    const std::string_view content = text_of(parent.content);
    const std::size_t blanks = std::min(content.find_first_not_of(" \t\r\n"), content.size());
    const bool has_children = blanks < content.size() && content[blanks] == '<';
    const std::string indent = has_children ? std::string(content.substr(0, blanks)) : "";
    edits_.push_back({{parent.tag.last, parent.tag.last}, indent + body});
  }

  void note(const std::string& name, double value) { note(name, "none", value); }

  std::string finish() {
    // From the last to the first, so that those before stay where they are.
    std::stable_sort(edits_.begin(), edits_.end(),
                     [](const Edit& a, const Edit& b) { return a.old.first < b.old.first; });
    std::string text = model_;
    for (auto edit = edits_.rbegin(); edit != edits_.rend(); ++edit) {
      text.replace(edit->old.first, edit->old.last - edit->old.first, edit->text);
    }
    return text;
  }

 private:
  [[nodiscard]] std::string_view text_of(const Stretch& stretch) const {
    return std::string_view(model_).substr(stretch.first, stretch.last - stretch.first);
  }

  void change(Stretch old, std::string text, const std::string& name, const std::string& was,
              double value) {
    edits_.push_back({old, std::move(text)});
    note(name, was, value);
  }

  void note(const std::string& name, const std::string& was, double value) {
    made_.changes.push_back(fmt::format("{}: {} -> {}", name, printable(was), shortest(value)));
  }

  const std::string& model_;
  PatchedModel& made_;
  std::vector<Edit> edits_;
};

void edit_urdf(const FoundJoint& found, const DryAndViscous& friction, JointEditor& editor) {
  if (found.dynamics) {
    editor.set_attribute(*found.dynamics, "damping", friction.viscous_Nms_rad);
    editor.set_attribute(*found.dynamics, "friction", friction.dry_Nm);
    return;
  }
  editor.add_child(*found.joint, "joint",
                   fmt::format("<dynamics damping=\"{}\" friction=\"{}\"/>",
                               shortest(friction.viscous_Nms_rad), shortest(friction.dry_Nm)));
  editor.note("damping", friction.viscous_Nms_rad);
  editor.note("friction", friction.dry_Nm);
}

void edit_sdf(const FoundJoint& found, const DryAndViscous& friction, JointEditor& editor) {
  if (!found.axis) {
    throw InputError(found.where, {"has a joint without an axis", "", "<axis> in the joint", ""});
  }
  const auto element = [](const char* name, double value) {
    return fmt::format("<{0}>{1}</{0}>", name, shortest(value));
  };
  std::string missing;
  const auto set = [&](const std::optional<Element>& one, const char* name, double value) {
    if (one) {
      editor.set_content(*one, name, value);
    } else {
      missing += element(name, value);
      editor.note(name, value);
    }
  };
  set(found.damping, "damping", friction.viscous_Nms_rad);
  set(found.friction, "friction", friction.dry_Nm);
  if (missing.empty()) return;
  if (found.dynamics) {
    editor.add_child(*found.dynamics, "dynamics", missing);
  } else {
    editor.add_child(*found.axis, "axis", "<dynamics>" + missing + "</dynamics>");
  }
}

}  // namespace

PatchedModel with_friction(const std::string& model, const std::string& file,
                           const std::string& name, const ArchivedJoint& joint,
                           const SimulatorOptions& options) {
  if (model.starts_with("\xFE\xFF") || model.starts_with("\xFF\xFE")) {
    throw InputError({file}, {"is UTF-16", "", "UTF-8", "iconv -f UTF-16 -t UTF-8"});
  }
  ModelReader reader(file, name);
  const FoundJoint found = reader.read(model);
  PatchedModel made;
  made.format = reader.format();
  const bool is_mjcf = made.format == "MJCF";
  const DryAndViscous friction =
      dry_and_viscous(joint, options, is_mjcf ? "frictionloss" : "friction", "damping");
  made.remarks = friction.comments;
  JointEditor editor(model, made);
  if (is_mjcf) {
    editor.set_attribute(*found.joint, "damping", friction.viscous_Nms_rad);
    editor.set_attribute(*found.joint, "frictionloss", friction.dry_Nm);
    editor.add_attribute(*found.joint, "solimpfriction", mjcf_hard_friction);
    made.remarks.emplace_back(mjcf_hard_friction_words);
    const Armature armature = armature_of(joint, options);
    if (armature.kgm2) editor.set_attribute(*found.joint, "armature", *armature.kgm2);
    made.remarks.push_back(armature.words);
  } else if (made.format == "URDF") {
    edit_urdf(found, friction, editor);
  } else {
    edit_sdf(found, friction, editor);
  }
  made.text = editor.finish();
  return made;
}

}  // namespace tribolog::exports::results
