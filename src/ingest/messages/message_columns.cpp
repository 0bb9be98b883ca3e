#include "ingest/messages/message_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace tribolog::ingest::messages {
namespace {

constexpr std::size_t most_columns = 5000;
constexpr std::size_t most_places = 4 * most_columns;
constexpr std::size_t longest_path = 512;
/// Of all columns of a topic; then those with a number in less than a sixteenth of the rows go.
constexpr std::size_t most_sparse_cells = std::size_t{1} << 25;
constexpr std::size_t rows_of_a_number = 16;
constexpr std::size_t no_column = std::numeric_limits<std::size_t>::max();

std::string joined(const std::string& path, std::string_view name) {
  return path.empty() ? std::string(name) : path + "." + std::string(name);
}

}  // namespace

struct MessageColumns::Place {
  std::string path;
  std::size_t column{no_column};
  std::vector<std::unique_ptr<Place>> parts;  ///< Fields, or elements, by number.
  std::map<std::string, std::unique_ptr<Place>, std::less<>> named;
};

MessageColumns::MessageColumns() : root_(std::make_unique<Place>()) {}
MessageColumns::~MessageColumns() = default;

MessageColumns::Place* MessageColumns::field(Place* parent, std::size_t number,
                                             std::string_view name) {
  if (parent == nullptr) return nullptr;
  if (parent->parts.size() <= number) parent->parts.resize(number + 1);
  std::unique_ptr<Place>& part = parent->parts[number];
  return part ? part.get() : added(part, joined(parent->path, name));
}

MessageColumns::Place* MessageColumns::field(Place* parent, std::string_view name) {
  if (parent == nullptr) return nullptr;
  const auto found = parent->named.find(name);
  if (found != parent->named.end()) return found->second.get();
  std::unique_ptr<Place> part;
  Place* const place = added(part, joined(parent->path, name));
  if (place != nullptr) parent->named.emplace(std::string(name), std::move(part));
  return place;
}

MessageColumns::Place* MessageColumns::element(Place* array, std::size_t number) {
  if (array == nullptr) return nullptr;
  if (array->parts.size() <= number) array->parts.resize(number + 1);
  std::unique_ptr<Place>& part = array->parts[number];
  return part ? part.get() : added(part, fmt::format("{}[{}]", array->path, number));
}

MessageColumns::Place* MessageColumns::named_element(Place* parent, Place* array,
                                                     std::string_view name,
                                                     std::string_view field) {
  if (parent == nullptr || array == nullptr) return nullptr;
  const auto found = array->named.find(name);
  if (found != array->named.end()) return found->second.get();
  std::string path = joined(parent->path, name);
  if (!field.empty()) path = joined(path, field);
  if (named_paths_.contains(path)) path = joined(array->path, name);
  std::unique_ptr<Place> part;
  Place* const place = added(part, path);
  if (place == nullptr) return nullptr;
  named_paths_.insert(std::move(path));
  array->named.emplace(std::string(name), std::move(part));
  return place;
}

MessageColumns::Place* MessageColumns::added(std::unique_ptr<Place>& where, std::string path) {
  if (places_ == most_places || path.size() > longest_path) {
    has_too_many_columns_ = true;
    return nullptr;
  }
  ++places_;
  where = std::make_unique<Place>();
  where->path = std::move(path);
  return where.get();
}

void MessageColumns::put(Place* place, double value) {
  if (place == nullptr) return;
  if (place->column == no_column) {
    if (columns_.size() == most_columns) {
      has_too_many_columns_ = true;
      return;
    }
    place->column = columns_.size();
    columns_.push_back({{place->path, place->path, ""}, {}, 0});
    numbers_.push_back(0);
    is_left_out_.push_back(false);
  }
  if (!grow(place->column, rows_ + 1)) return;
  ++numbers_[place->column];
  columns_[place->column].values.back() =
      std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
}

bool MessageColumns::grow(std::size_t column, std::size_t rows) {
  if (is_left_out_[column]) return false;
  std::vector<double>& values = columns_[column].values;
  const std::size_t cells = cells_ - values.size() + rows;
  const bool is_sparse = rows / rows_of_a_number > numbers_[column];
  if (is_sparse && rows > values.size() && cells > most_sparse_cells) {
    cells_ -= values.size();
    std::vector<double>().swap(values);
    is_left_out_[column] = true;
    has_too_many_columns_ = true;
    return false;
  }
  values.resize(rows, std::numeric_limits<double>::quiet_NaN());
  cells_ = cells;
  return true;
}

void MessageColumns::fill_gaps() {
  for (std::size_t i = 0; i < columns_.size(); ++i) (void)grow(i, rows_);
}

void MessageColumns::leave_out(const Place* long_array) {
  if (long_array == nullptr) return;
  const bool is_known =
      std::find(long_arrays_.begin(), long_arrays_.end(), long_array->path) != long_arrays_.end();
  if (!is_known) long_arrays_.push_back(long_array->path);
}

void MessageColumns::end_row(bool is_too_long) {
  ++rows_;
  if (is_too_long) ++too_long_;
}

std::vector<log::LogColumn> MessageColumns::finish() && {
  fill_gaps();
  std::vector<log::LogColumn> kept;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (is_left_out_[i]) continue;
    log::LogColumn& column = kept.emplace_back(std::move(columns_[i]));
    column.gaps =
        static_cast<std::size_t>(std::count_if(column.values.begin(), column.values.end(),
                                               [](double value) { return std::isnan(value); }));
  }
  return kept;
}

}  // namespace tribolog::ingest::messages
