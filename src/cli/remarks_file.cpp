#include "cli/remarks_file.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/input_file.h"
#include "base/shown_text.h"
#include "report/engine/embedded_json.h"

namespace tribolog::cli {

using nlohmann::json;

std::string report_number(const std::string& page, const std::string& file) {
  const auto loops = report::engine::json_in(page, "tribolog-loops", file);
  return loops ? json::parse(*loops).value("report", "") : "";
}

std::vector<Remark> read_remarks(const std::string& path, const std::string& report) {
  const auto refuse = [&](const std::string& what, const std::string& found,
                          const std::string& expected) {
    throw InputError({path, 0, 0}, {what, printable(found), printable(expected),
                                    "\"Save remarks\" in the viewer of a report writes them"});
  };
  const json file = json::parse(read_file(path), nullptr, false);
  const auto text_of = [](const json& object, const char* key) {
    const auto value = object.is_object() ? object.find(key) : object.end();
    return value != object.end() && value->is_string() ? value->get<std::string>() : "";
  };
  const bool is_list = file.is_object() && file.contains("remarks") && file["remarks"].is_array();
  if (!is_list || file["remarks"].empty()) refuse("no remarks", "", "a JSON file of remarks");
  if (const std::string of = text_of(file, "report"); of != report || report.empty()) {
    refuse("these remarks are on another report", of, report);
  }
  std::vector<Remark> remarks;
  for (const json& one : file["remarks"]) {
    remarks.push_back({text_of(one, "place"), text_of(one, "text")});
    if (remarks.back().place.empty() || remarks.back().text.empty()) {
      refuse("a remark without place or text", one.dump(), "both");
    }
  }
  return remarks;
}

}  // namespace tribolog::cli
