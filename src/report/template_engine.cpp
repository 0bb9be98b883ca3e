#include "report/template_engine.h"

#include <cstddef>
#include <deque>
#include <mutex>
#include <set>
#include <stdexcept>
#include <utility>

#include <ctemplate/template.h>
#include <ctemplate/template_annotator.h>
#include <ctemplate/template_cache.h>
#include <ctemplate/template_dictionary.h>

#include "report/embedded_files.h"
#include "report/template_language.h"
#include "report/template_modifiers.h"
#include "wording/visible_text.h"

namespace tribolog::report {
namespace {

constexpr char pragma[] = "{{%AUTOESCAPE context=\"HTML\"}}";

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

/// The templates in one language.
struct Templates {
  ctemplate::TemplateCache cache;
  /// By file, the variables that stand inside a tag and are not read there: classes, anchors.
  /// Empty in English, where nothing is translated.
  std::map<std::string, std::set<std::string, std::less<>>, std::less<>> words_for_machines;
};

std::unique_ptr<Templates> load_templates(wording::Language language) {
  register_template_modifiers();
  auto templates = std::make_unique<Templates>();
  const wording::Catalogue* const catalogue = wording::catalogue_of(language);
  for (const EmbeddedFile& file : embedded_files()) {
    if (!ends_with(file.name, ".tpl")) continue;
    const std::string name(file.name);
    if (file.text.rfind(pragma, 0) != 0) {
      throw std::logic_error("template " + name + " does not begin with the AUTOESCAPE pragma");
    }
    std::string text(file.text);
    if (catalogue != nullptr) {
      templates->words_for_machines[name] = variables_inside_tags(file.text);
      text = template_in_language(file.text, [catalogue](const std::string& message) {
        return catalogue->find_in_templates(message);
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

const Templates& templates_in(wording::Language language) {
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
  DictionaryFiller(const Templates& templates, wording::Language language)
      : templates_(templates), catalogue_(wording::catalogue_of(language)) {}

  /// @param file whose values these are.
  void fill(const TemplateValues& values, const std::string& file,
            ctemplate::TemplateDictionary& dictionary) {
    for (const auto& [variable, value] : values.texts_) {
      const bool is_translated = catalogue_ != nullptr && value.is_translated &&
                                 !templates_.words_for_machines.at(file).contains(variable);
      const std::string& text = is_translated ? translated(value.text) : value.text;
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
      fill(*child.values, child.file.empty() ? file : child.file, *inner);
    }
  }

 private:
  const std::string& translated(const std::string& text) {
    return kept_.emplace_back(catalogue_->translate(text));
  }

  const Templates& templates_;
  const wording::Catalogue* catalogue_;
  std::deque<std::string> kept_;  ///< The dictionary holds no copies.
};

void TemplateValues::set(const std::string& variable, const std::string& text) {
  if (text.empty()) throw std::logic_error("template variable " + variable + " is empty");
  texts_[variable] = {wording::visible_text(text), true};
}

void TemplateValues::set_name(const std::string& variable, const std::string& text) {
  set(variable, text);
  texts_[variable].is_translated = false;
}

void TemplateValues::set_checked_by_modifier(const std::string& variable, std::string text) {
  texts_[variable] = {std::move(text), false};
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
                            wording::Language language) {
  const Templates& templates = templates_in(language);
  ctemplate::TemplateDictionary dictionary("report");
  dictionary.SetGlobalValue("LANGUAGE", wording::code_of(language));
  DictionaryFiller filler(templates, language);
  filler.fill(values, file, dictionary);
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

}  // namespace tribolog::report
