#pragma once
// The template engine behind plain text: every value goes through one door, and none is forgotten.
//
// ctemplate escapes each value for the place where it stands, but lets three things pass, each of
// which is refused here: a template file without the AUTOESCAPE pragma, a variable that was not
// set (it would print as nothing), and text that is not UTF-8 or that hides characters.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "wording/language.h"

namespace tribolog::report::engine {

/// Values for one template or one section of it. What is not shown is not printed.
class TemplateValues {
 public:
  /// A text that may come from anywhere, in the language of the page. Must not be empty: what may
  /// be absent stands in a section. @throw std::logic_error naming the variable if it is empty.
  void set(const std::string& variable, const std::string& text);
  /// A text that the template prints through a modifier of ours (PNG, JSON, CSS): it is kept
  /// byte by byte, and the modifier checks it.
  void set_checked_by_modifier(const std::string& variable, std::string text);
  /// One more repetition of a section.
  TemplateValues& add_section(const std::string& section);
  /// One more repetition of an included template.
  TemplateValues& add_include(const std::string& marker, const std::string& file);
  /// Sets the variable inside a section of the same name with `_IF` behind it; nothing if empty.
  void set_optional(const std::string& variable, const std::string& text);

 private:
  friend class DictionaryFiller;
  struct Child {
    std::string name;
    std::string file;  ///< Empty: a section.
    std::unique_ptr<TemplateValues> values;
  };
  std::map<std::string, std::string> texts_;
  std::vector<Child> children_;
};

/// Expands an embedded template in a language.
/// @throw std::logic_error if a template cannot be loaded, or a variable was left unset.
std::string expand_template(const std::string& file, const TemplateValues& values,
                            const wording::Language& language = {});

}  // namespace tribolog::report::engine
