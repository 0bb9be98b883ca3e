#include "archive/store/kept_texts.h"

#include "archive/sql/kept_text.h"
#include "archive/store/entry_rows.h"
#include "base/error.h"

namespace tribolog::archive {
namespace {

void refuse_unkept(const std::string& text) {
  if (!sql::is_kept_text(text)) {
    throw UsageError("an archive keeps texts in UTF-8, without the character NUL: '" +
                     printable(text) + "' is none");
  }
}

}  // namespace

void refuse_unkept_texts(const std::vector<sql::Value>& values) {
  for (const sql::Value& value : values) {
    if (const auto* text = std::get_if<std::string>(&value.content())) refuse_unkept(*text);
  }
}

void refuse_unkept_texts(const NewCalibration& calibration) {
  Entry entry;
  entry.facts = calibration.facts;
  refuse_unkept_texts(values_of(entry));
  for (const Quantity& q : calibration.quantities) {
    for (const std::string* text : {&q.name, &q.words, &q.unit}) refuse_unkept(*text);
  }
  for (const Input& input : calibration.inputs) {
    for (const std::string* text : {&input.name, &input.role}) refuse_unkept(*text);
  }
  for (const Document& document : calibration.documents) refuse_unkept(document.name);
}

}  // namespace tribolog::archive
