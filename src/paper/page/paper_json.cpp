#include "paper/page/paper_json.h"

#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

namespace tribolog::report {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

const char* name_of(paper::Origin origin) {
  switch (origin) {
    case paper::Origin::printed:
      return "printed";
    case paper::Origin::reconstructed:
      return "reconstructed";
    case paper::Origin::law:
      return "law";
  }
  return "";
}

const char* name_of(paper::ItemKind kind) {
  switch (kind) {
    case paper::ItemKind::figure:
      return "figure";
    case paper::ItemKind::table:
      return "table";
    case paper::ItemKind::equation:
      return "equation";
    case paper::ItemKind::statement:
      return "statement";
  }
  return "";
}

Json list_of(const paper::Checks& checks) {
  Json list = Json::array();
  for (const paper::Check& check : checks) {
    Json one{{"what", check.what}, {"origin", name_of(check.origin)}};
    if (check.is_words()) {
      one["expected"] = check.expected_words;
      one["ours"] = check.ours_words;
    } else {
      one["expected"] = number(check.expected);
      one["ours"] = number(check.ours);
      one["difference"] = number(check.difference());
      one["allowed"] = number(check.bound);
      one["unit"] = check.unit;
    }
    one["holds"] = check.holds();
    list.push_back(std::move(one));
  }
  return list;
}

}  // namespace

std::string paper_json(const RegeneratedPaper& paper) {
  Json items = Json::array();
  for (const paper::PaperSection& section : paper.sections) {
    for (const paper::PaperItem& item : section.items) {
      items.push_back({{"kind", name_of(item.kind)},
                       {"number", item.number},
                       {"section", section.number},
                       {"title", item.title},
                       {"checks", list_of(item.checks)}});
    }
  }
  const Json whole{{"schema", "tribolog-paper-1"},
                   {"tool", paper.provenance.tool_version},
                   {"items", std::move(items)},
                   {"golden_numbers", list_of(paper.golden_numbers)}};
  return whole.dump();
}

}  // namespace tribolog::report
