#include "report/engine/template_engine.h"

#include <cstddef>
#include <mutex>
#include <stdexcept>
#include <utility>

#include <ctemplate/template.h>
#include <ctemplate/template_annotator.h>
#include <ctemplate/template_cache.h>
#include <ctemplate/template_dictionary.h>

#include "report/engine/embedded_files.h"
#include "report/engine/template_language.h"
#include "report/engine/template_modifiers.h"
#include "wording/translation.h"
#include "wording/visible_text.h"

namespace tribolog::report::engine {
namespace {

constexpr char pragma[] = "{{%AUTOESCAPE context=\"HTML\"}}";

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

/// The templates in one language.
struct Templates {
  ctemplate::TemplateCache cache;
};

std::unique_ptr<Templates> load_templates(const wording::Language& language) {
  const wording::WordsIn words(language);
  register_template_modifiers();
  auto templates = std::make_unique<Templates>();
  for (const EmbeddedFile& file : embedded_files()) {
    if (!ends_with(file.name, ".tpl")) continue;
    const std::string name(file.name);
    if (file.text.rfind(pragma, 0) != 0) {
      throw std::logic_error("template " + name + " does not begin with the AUTOESCAPE pragma");
    }
    std::string text(file.text);
    if (!language.is_english()) {
      text = template_in_language(file.text, [](const std::string& message) {
        std::string found = wording::translated(message);
        return found == message ? std::string() : found;
      });
    }
    if (!templates->cache.StringToTemplateCache(name, text.data(), text.size(),
                                                ctemplate::STRIP_BLANK_LINES)) {
      throw std::logic_error("template " + name + " cannot be parsed");
    }
  }
  templates->cache.Freeze();
  return templates;
}

const Templates& templates_in(const wording::Language& language) {
  static std::map<wording::Language, std::unique_ptr<Templates>> loaded;
  static std::mutex loading;
  const std::lock_guard<std::mutex> lock(loading);
  std::unique_ptr<Templates>& templates = loaded[language];
  if (!templates) templates = load_templates(language);
  return *templates;
}

/// Prints nothing; notes the variables that print nothing, and files that are not there.
class UnsetVariables : public ctemplate::TemplateAnnotator {
 public:
  explicit UnsetVariables(const std::string& output) : output_(output) {}
  void EmitOpenInclude(ctemplate::ExpandEmitter*, const std::string&) override {}
  void EmitCloseInclude(ctemplate::ExpandEmitter*) override {}
  void EmitOpenFile(ctemplate::ExpandEmitter*, const std::string& file) override { file_ = file; }
  void EmitCloseFile(ctemplate::ExpandEmitter*) override {}
  void EmitOpenSection(ctemplate::ExpandEmitter*, const std::string&) override {}
  void EmitCloseSection(ctemplate::ExpandEmitter*) override {}
  void EmitOpenVariable(ctemplate::ExpandEmitter*, const std::string& variable) override {
    variable_ = variable;
    before_ = output_.size();
  }
  void EmitCloseVariable(ctemplate::ExpandEmitter*) override {
    if (output_.size() == before_) found += " " + variable_ + " (" + file_ + ")";
  }
  void EmitFileIsMissing(ctemplate::ExpandEmitter*, const std::string& file) override {
    found += " file " + file;
  }
  std::string found;

 private:
  const std::string& output_;
  std::string file_;
  std::string variable_;
  std::size_t before_{};
};

}  // namespace

class DictionaryFiller {
 public:
  /// The dictionary holds no copies: the values must outlive it.
  static void fill(const TemplateValues& values, ctemplate::TemplateDictionary& dictionary) {
    for (const auto& [variable, text] : values.texts_) {
      dictionary.SetValueWithoutCopy(variable, ctemplate::TemplateString(text.data(), text.size()));
    }
    for (const TemplateValues::Child& child : values.children_) {
      ctemplate::TemplateDictionary* inner = nullptr;
      if (child.file.empty()) {
        inner = dictionary.AddSectionDictionary(child.name);
      } else {
        inner = dictionary.AddIncludeDictionary(child.name);
        inner->SetFilename(child.file);
      }
      fill(*child.values, *inner);
    }
  }
};

void TemplateValues::set(const std::string& variable, const std::string& text) {
  if (text.empty()) throw std::logic_error("template variable " + variable + " is empty");
  texts_[variable] = wording::visible_text(text);
}

void TemplateValues::set_checked_by_modifier(const std::string& variable, std::string text) {
  texts_[variable] = std::move(text);
}

void TemplateValues::set_optional(const std::string& variable, const std::string& text) {
  if (!text.empty()) add_section(variable + "_IF").set(variable, text);
}

TemplateValues& TemplateValues::add_section(const std::string& section) {
  children_.push_back({section, "", std::make_unique<TemplateValues>()});
  return *children_.back().values;
}

TemplateValues& TemplateValues::add_include(const std::string& marker, const std::string& file) {
  children_.push_back({marker, file, std::make_unique<TemplateValues>()});
  return *children_.back().values;
}

std::string expand_template(const std::string& file, const TemplateValues& values,
                            const wording::Language& language) {
  const Templates& templates = templates_in(language);
  ctemplate::TemplateDictionary dictionary("report");
  // Of this page alone: a global value would be that of all threads, whatever their languages.
  dictionary.SetTemplateGlobalValue("LANGUAGE", language.code);
  DictionaryFiller::fill(values, dictionary);
  std::string output;
  UnsetVariables unset(output);
  ctemplate::PerExpandData data;
  data.SetAnnotateOutput("");
  data.SetAnnotator(&unset);
  if (!templates.cache.ExpandNoLoad(file, ctemplate::STRIP_BLANK_LINES, &dictionary, &data,
                                    &output)) {
    throw std::logic_error("template " + file + " cannot be expanded;" + unset.found);
  }
  if (!unset.found.empty()) throw std::logic_error("template variables not set:" + unset.found);
  return output;
}

}  // namespace tribolog::report::engine
