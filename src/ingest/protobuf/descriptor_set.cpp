#include "ingest/protobuf/descriptor_set.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <google/protobuf/descriptor.pb.h>

#include "base/error.h"
#include "ingest/messages/topic_tables.h"

namespace tribolog::ingest::protobuf {
namespace {

namespace pb = google::protobuf;
using messages::SchemaError;

// What a description of a robot's messages never reaches; damaged ones are refused before they take
// memory.
constexpr std::size_t largest_set_bytes = std::size_t{4} << 20;
constexpr int most_files = 1000;

/// Keeps the first thing that is wrong with a file.
class FirstError : public pb::DescriptorPool::ErrorCollector {
 public:
#if GOOGLE_PROTOBUF_VERSION >= 4022000
  void RecordError(absl::string_view, absl::string_view element, const pb::Message*, ErrorLocation,
                   absl::string_view message) override {
    keep(std::string(element), std::string(message));
  }
#else
  void AddError(const std::string&, const std::string& element, const pb::Message*, ErrorLocation,
                const std::string& message) override {
    keep(element, message);
  }
  void AddWarning(const std::string&, const std::string&, const pb::Message*, ErrorLocation,
                  const std::string&) override {}
#endif
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void keep(const std::string& element, const std::string& message) {
    if (text_.empty()) text_ = fmt::format("{}: {}", element, message);
  }
  std::string text_;
};

pb::FileDescriptorSet parsed(std::string_view bytes) {
  if (bytes.size() > largest_set_bytes) {
    throw SchemaError(fmt::format("its FileDescriptorSet has {} bytes, more than {}", bytes.size(),
                                  largest_set_bytes));
  }
  pb::FileDescriptorSet set;
  if (!set.ParsePartialFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
    throw SchemaError("its schema is no FileDescriptorSet of protobuf, or is damaged");
  }
  if (set.file_size() > most_files) {
    throw SchemaError(fmt::format("its FileDescriptorSet has {} files, more than {}",
                                  set.file_size(), most_files));
  }
  return set;
}

/// Adds files in the order of their imports, without descending into them.
class PoolFilling {
 public:
  PoolFilling(const pb::FileDescriptorSet& set, pb::DescriptorPool& pool)
      : set_(set), pool_(pool), is_added_(static_cast<std::size_t>(set.file_size())) {}

  void add_all() {
    for (bool adds = true; adds;) {
      adds = false;
      for (int i = 0; i < set_.file_size(); ++i) {
        if (is_added_[static_cast<std::size_t>(i)] || !missing_import(set_.file(i)).empty())
          continue;
        add(i);
        adds = true;
      }
    }
    for (int i = 0; i < set_.file_size(); ++i) {
      if (!is_added_[static_cast<std::size_t>(i)]) note_missing(set_.file(i));
    }
  }

  /// Empty: nothing was wrong.
  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  std::string missing_import(const pb::FileDescriptorProto& file) const {
    for (const std::string& name : file.dependency()) {
      if (!names_.contains(name)) return name;
    }
    return {};
  }

  void add(int number) {
    const pb::FileDescriptorProto& file = set_.file(number);
    is_added_[static_cast<std::size_t>(number)] = true;
    if (!names_.insert(file.name()).second) return;  // it stands there twice
    FirstError error;
    if (pool_.BuildFileCollectingErrors(file, &error) != nullptr) return;
    names_.erase(file.name());
    if (problem_.empty()) {
      problem_ =
          fmt::format("'{}' is damaged: {}", printable(file.name()), printable(error.text(), 200));
    }
  }

  void note_missing(const pb::FileDescriptorProto& file) {
    if (!problem_.empty()) return;
    problem_ = fmt::format("'{}' imports '{}', which is not there or imports it in turn",
                           printable(file.name()), printable(missing_import(file)));
  }

  const pb::FileDescriptorSet& set_;
  pb::DescriptorPool& pool_;
  std::vector<bool> is_added_;
  std::set<std::string> names_;
  std::string problem_;
};

}  // namespace

const pb::Descriptor* type_in(std::string_view bytes, const std::string& type,
                              pb::DescriptorPool& pool) {
  const pb::FileDescriptorSet set = parsed(bytes);
  PoolFilling filling(set, pool);
  filling.add_all();
  const pb::Descriptor* const found = pool.FindMessageTypeByName(type);
  if (found != nullptr) return found;
  const std::string why = filling.problem().empty() ? "" : ": " + filling.problem();
  throw SchemaError("its FileDescriptorSet does not define " + printable(type) + why);
}

}  // namespace tribolog::ingest::protobuf
