#include "report/template_modifiers.h"

#include <string_view>

#include <ctemplate/template_emitter.h>
#include <ctemplate/template_modifiers.h>

#include "report/embedded_files.h"

namespace tribolog::report {
namespace {

class PngUri : public ctemplate::TemplateModifier {
 public:
  void Modify(const char* in, std::size_t length, const ctemplate::PerExpandData*,
              ctemplate::ExpandEmitter* out, const std::string&) const override {
    constexpr std::string_view alphabet =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/=";
    const std::string_view text(in, length);
    out->Emit("data:image/png;base64,");
    if (text.find_first_not_of(alphabet) == std::string_view::npos) out->Emit(in, length);
  }
};

class ScriptJson : public ctemplate::TemplateModifier {
 public:
  void Modify(const char* in, std::size_t length, const ctemplate::PerExpandData*,
              ctemplate::ExpandEmitter* out, const std::string&) const override {
    out->Emit(json_for_script({in, length}));
  }
};

class OwnStyle : public ctemplate::TemplateModifier {
 public:
  void Modify(const char* in, std::size_t length, const ctemplate::PerExpandData*,
              ctemplate::ExpandEmitter* out, const std::string&) const override {
    if (std::string_view(in, length) == embedded_file(style_sheet_name)) out->Emit(in, length);
  }
};

}  // namespace

std::string json_for_script(const std::string& json) {
  std::string safe;
  safe.reserve(json.size());
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::string_view rest(json.data() + i, json.size() - i);
    if (json[i] == '<') {
      safe += "\\u003c";
    } else if (json[i] == '>') {
      safe += "\\u003e";
    } else if (json[i] == '&') {
      safe += "\\u0026";
    } else if (rest.substr(0, 3) == "\u2028" || rest.substr(0, 3) == "\u2029") {
      safe += rest.substr(0, 3) == "\u2028" ? "\\u2028" : "\\u2029";
      i += 2;
    } else {
      safe += json[i];
    }
  }
  return safe;
}

void register_template_modifiers() {
  static const PngUri png;
  static const ScriptJson json;
  static const OwnStyle css;
  static const bool once = ctemplate::AddXssSafeModifier("x-png", &png) &&
                           ctemplate::AddXssSafeModifier("x-json", &json) &&
                           ctemplate::AddXssSafeModifier("x-css", &css);
  static_cast<void>(once);
}

}  // namespace tribolog::report
