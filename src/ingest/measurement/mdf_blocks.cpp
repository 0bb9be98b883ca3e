#include "ingest/measurement/mdf_blocks.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/utf8.h"
#include "ingest/arrays/byte_order.h"

namespace tribolog::ingest::measurement {

using arrays::number_at;

namespace {

constexpr std::size_t header_bytes = 24;
constexpr std::size_t longest_text = 1024;
constexpr const char* may_be_cut = "the file may be cut off: copy it again";

template <class Number>
Number field(std::string_view data, std::size_t at) {
  if (at > data.size() || data.size() - at < sizeof(Number)) return {};
  return number_at<Number>(data, at);
}

/// What stands between <TX> and </TX>, with the entities that XML itself has.
std::string text_in_xml(std::string_view xml) {
  const std::size_t tag = xml.find("<TX");
  if (tag == std::string_view::npos) return "";
  const std::size_t begin = xml.find('>', tag);
  const std::size_t end = xml.find("</TX>", tag);
  if (begin == std::string_view::npos || end == std::string_view::npos || begin >= end) return "";
  std::string text(xml.substr(begin + 1, end - begin - 1));
  constexpr std::array<std::pair<std::string_view, char>, 5> entities{
      {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}}};
  for (const auto& [entity, character] : entities) {
    for (std::size_t at = text.find(entity); at != std::string::npos;
         at = text.find(entity, at + 1))
      text.replace(at, entity.size(), 1, character);
  }
  return text;
}

/// Without what follows a NUL, and without blanks around it.
std::string trimmed(std::string_view text) {
  text = text.substr(0, text.find('\0'));
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return "";
  return std::string(text.substr(begin, text.find_last_not_of(blanks) + 1 - begin));
}

/// At most so many bytes, and no half character at the end.
std::string cut_text(std::string text) {
  if (text.size() <= longest_text) return text;
  std::size_t end = longest_text;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;
  text.resize(end);
  return text;
}

}  // namespace

MdfLink MdfBlock::link(std::size_t index) const {
  return index < links_ ? number_at<std::uint64_t>(bytes_, header_bytes + 8 * index) : 0;
}

std::string_view MdfBlock::data() const { return bytes_.substr(header_bytes + 8 * links_); }
std::uint8_t MdfBlock::uint8(std::size_t at) const { return field<std::uint8_t>(data(), at); }
std::uint16_t MdfBlock::uint16(std::size_t at) const { return field<std::uint16_t>(data(), at); }
std::uint32_t MdfBlock::uint32(std::size_t at) const { return field<std::uint32_t>(data(), at); }
std::uint64_t MdfBlock::uint64(std::size_t at) const { return field<std::uint64_t>(data(), at); }
double MdfBlock::float64(std::size_t at) const { return field<double>(data(), at); }

void MdfBlocks::refuse(const std::string& what, const std::string& found,
                       const std::string& expected) const {
  throw InputError({file_, 0, 0}, {what, found, expected, ""});
}

std::string_view MdfBlocks::mark_at(MdfLink link) const {
  if (link == 0 || link > bytes_.size() || bytes_.size() - link < header_bytes) return {};
  return bytes_.substr(link, 4);
}

void MdfBlocks::count(MdfLink link, std::uint64_t length) {
  if (!met_.insert(link).second) return;
  // Blocks that overlap could be read again and again, far more than the file holds.
  if (length > bytes_.size() - read_bytes_) {
    refuse(fmt::format("damaged: the block at byte {} overlaps others", link));
  }
  read_bytes_ += length;
}

MdfBlock MdfBlocks::block(MdfLink link, const std::vector<std::string_view>& marks) {
  const std::string wanted(marks.front());
  if (link > bytes_.size() || bytes_.size() - link < header_bytes) {
    throw InputError({file_, 0, 0},
                     {fmt::format("block {} stands beyond the file's end", wanted),
                      fmt::format("a link to byte {} of {}", link, bytes_.size()), "", may_be_cut});
  }
  const std::string_view rest = bytes_.substr(link);
  const std::string_view mark = rest.substr(0, 4);
  if (std::find(marks.begin(), marks.end(), mark) == marks.end()) {
    refuse(fmt::format("damaged: no block {} at byte {}", wanted, link), in_quotes(mark));
  }
  const auto length = number_at<std::uint64_t>(rest, 8);
  const auto links = number_at<std::uint64_t>(rest, 16);
  if (length < header_bytes || links > (length - header_bytes) / 8) {
    refuse(fmt::format("damaged: the length of block {} at byte {} does not hold its links", wanted,
                       link),
           fmt::format("{} bytes, {} links", length, links));
  }
  const std::uint64_t there = std::min<std::uint64_t>(length, rest.size());
  if (there < length && mark != "##DT") {
    throw InputError(
        {file_, 0, 0},
        {fmt::format("block {} at byte {} reaches beyond the file's end", wanted, link),
         fmt::format("{} bytes of {}", there, length), "", may_be_cut});
  }
  if (links > (there - header_bytes) / 8) {
    refuse(fmt::format("damaged: block {} at byte {} ends inside its links", wanted, link));
  }
  count(link, there);
  return {link, rest.substr(0, there), static_cast<std::size_t>(links)};
}

MdfBlock MdfBlocks::once(MdfLink link, const std::vector<std::string_view>& marks) {
  MdfBlock found = block(link, marks);
  if (!once_.insert(link).second) {
    refuse(fmt::format("damaged: block {} at byte {} is linked twice", found.mark(), link));
  }
  return found;
}

const std::string& MdfBlocks::text(MdfLink link) {
  if (const auto known = texts_.find(link); known != texts_.end()) return known->second;
  const MdfBlock found = block(link, {"##TX", "##MD"});
  // Of XML the text stands near the start; a longer one is a comment.
  constexpr std::size_t searched = 16 * longest_text;
  const std::string text = trimmed(found.data().substr(0, searched));
  const std::string plain = found.mark() == "##MD" ? trimmed(text_in_xml(text)) : text;
  const std::string cut = cut_text(plain);
  return texts_.emplace(link, first_broken_utf8(cut) ? utf8_of_latin1(cut) : cut).first->second;
}

}  // namespace tribolog::ingest::measurement
