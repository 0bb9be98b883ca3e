// Prints what templates and viewer say, as entries of a .po file without translations.

#include <cstdio>
#include <map>
#include <set>
#include <string>

#include "report/engine/embedded_files.h"
#include "report/engine/page_style.h"
#include "report/engine/template_language.h"

namespace {

/// As a .po file quotes it.
std::string quoted(const std::string& text) {
  std::string all = "\"";
  for (const char c : text) {
    if (c == '\n') {
      all += "\\n";
      continue;
    }
    if (c == '"' || c == '\\') all += '\\';
    all += c;
  }
  return all + "\"";
}

}  // namespace

int main() {
  using namespace tribolog;
  std::map<std::string, std::set<std::string>> files_of;
  for (const EmbeddedFile& file : report::engine::embedded_files()) {
    if (!file.name.ends_with(".tpl")) continue;
    for (const std::string& message : report::engine::messages_of_template(file.text)) {
      files_of[message].insert("templates/" + std::string(file.name));
    }
  }
  for (const std::string& message : report::engine::script_messages()) {
    files_of[message].insert("templates/viewer");
  }
  for (const auto& [message, files] : files_of) {
    for (const std::string& file : files) std::printf("#: %s\n", file.c_str());
    std::printf("msgid %s\nmsgstr \"\"\n\n", quoted(message).c_str());
  }
}
