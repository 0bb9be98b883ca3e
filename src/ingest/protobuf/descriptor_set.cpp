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

/// Adds files in the order of their imports, without descending into them. Some writers leave the
/// imports out: a file that needs what it does not import gets all that were added before it.
class PoolFilling {
 public:
  PoolFilling(const pb::FileDescriptorSet& set, pb::DescriptorPool& pool) : pool_(pool) {
    for (const pb::FileDescriptorProto& file : set.file()) waiting_.push_back(&file);
  }

  void add_all() {
    for (int pass = 0; pass < most_passes && !waiting_.empty(); ++pass) {
      const auto rest = std::remove_if(waiting_.begin(), waiting_.end(),
                                       [&](const auto* file) { return is_added(*file); });
      if (rest == waiting_.end()) return;
      waiting_.erase(rest, waiting_.end());
    }
  }

  /// Empty: all were added.
  [[nodiscard]] std::string problem() const {
    if (waiting_.empty()) return {};
    const pb::FileDescriptorProto& file = *waiting_.front();
    const std::string missing = missing_import(file);
    if (missing.empty()) {
      return fmt::format("'{}' is damaged: {}", printable(file.name()), printable(error_, 200));
    }
    return fmt::format("'{}' imports '{}', which is not there or imports it in turn",
                       printable(file.name()), printable(missing));
  }

 private:
  /// Each pass adds at least one file; imports are seldom as deep.
  static constexpr int most_passes = 64;

  std::string missing_import(const pb::FileDescriptorProto& file) const {
    for (const std::string& name : file.dependency()) {
      if (!names_.contains(name)) return name;
    }
    return {};
  }

  bool is_added(const pb::FileDescriptorProto& file) {
    if (names_.contains(file.name())) return true;  // it stands there twice
    if (!missing_import(file).empty()) return false;
    const bool is_built = build(file) || (file.dependency().empty() && build(with_imports(file)));
    if (is_built) names_.insert(file.name());
    return is_built;
  }

  bool build(const pb::FileDescriptorProto& file) {
    FirstError error;
    if (pool_.BuildFileCollectingErrors(file, &error) != nullptr) return true;
    error_ = error.text();
    return false;
  }

  [[nodiscard]] pb::FileDescriptorProto with_imports(pb::FileDescriptorProto file) const {
    for (const std::string& name : names_) file.add_dependency(name);
    return file;
  }

  pb::DescriptorPool& pool_;
  std::vector<const pb::FileDescriptorProto*> waiting_;
  std::set<std::string> names_;
  std::string error_;
};

}  // namespace

const pb::Descriptor* type_in(std::string_view bytes, const std::string& type,
                              pb::DescriptorPool& pool) {
  const pb::FileDescriptorSet set = parsed(bytes);
  PoolFilling filling(set, pool);
  filling.add_all();
  const pb::Descriptor* const found = pool.FindMessageTypeByName(type);
  if (found != nullptr) return found;
  const std::string problem = filling.problem();
  throw SchemaError(fmt::format("its FileDescriptorSet does not define {}{}{}", printable(type),
                                problem.empty() ? "" : ": ", problem));
}

}  // namespace tribolog::ingest::protobuf
