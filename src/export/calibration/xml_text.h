#pragma once
// Text of any origin inside XML.

#include <string>
#include <vector>

namespace tribolog::archive {

/// For an attribute in double quotes: what hides becomes visible, the rest is escaped. Never empty:
/// `instead` stands where there is no text.
std::string xml_attribute(const std::string& text, const std::string& instead);

/// A comment of several lines. "--", which would end it, becomes "- -".
std::string xml_comment(const std::vector<std::string>& lines, const std::string& indent);

/// The shortest that reads back to the same double.
std::string shortest(double number);

}  // namespace tribolog::archive
