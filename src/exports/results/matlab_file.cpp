#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "exports/results/archived_joint.h"
#include "exports/results/calibration_exports.h"
#include "exports/results/friction_table.h"

namespace tribolog::exports::results {
namespace {

/// Variables of a MAT file of level 4: a header of five whole numbers, the name, then the numbers
/// by columns, all little-endian (MAT-File Format, The MathWorks, appendix "MAT-File Version 4").
class MatVariables {
 public:
  void add_rows(const std::string& name, const std::vector<std::vector<double>>& rows) {
    const std::size_t columns = rows.empty() ? 0 : rows.front().size();
    begin(name, double_numbers, rows.size(), columns);
    for (std::size_t column = 0; column < columns; ++column) {
      for (const std::vector<double>& row : rows) put(std::bit_cast<std::uint64_t>(row[column]), 8);
    }
  }
  void add(const std::string& name, double number) { add_rows(name, {{number}}); }

  /// A row of characters: those of Latin-1, others as question marks.
  void add(const std::string& name, const std::string& text) {
    const std::string letters = latin1(text);
    begin(name, bytes_of_text, letters.empty() ? 0 : 1, letters.size());
    bytes_ += letters;
  }

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  static constexpr std::uint32_t double_numbers = 0;
  static constexpr std::uint32_t bytes_of_text = 51;

  void begin(const std::string& name, std::uint32_t type, std::size_t rows, std::size_t columns) {
    const std::array<std::uint64_t, 5> header{type, rows, columns, 0, name.size() + 1};
    for (const std::uint64_t number : header) put(number, 4);
    bytes_ += name;
    bytes_ += '\0';
  }

  void put(std::uint64_t number, int bytes) {
    for (int k = 0; k < bytes; ++k) bytes_ += static_cast<char>((number >> (8 * k)) & 0xffU);
  }

  static std::string latin1(const std::string& utf8) {
    std::string out;
    for (std::size_t i = 0; i < utf8.size(); ++i) {
      const auto byte = static_cast<unsigned char>(utf8[i]);
      if (byte < 0x80) {
        out += utf8[i];
      } else if ((byte == 0xc2 || byte == 0xc3) && i + 1 < utf8.size()) {
        ++i;
        out += static_cast<char>(static_cast<unsigned char>(utf8[i]) + (byte == 0xc3 ? 0x40 : 0));
      } else if (byte >= 0xc0) {
        out += '?';
      }
    }
    return out;
  }

  std::string bytes_;
};

std::vector<std::vector<double>> matrix_of(const FrictionTable& table) {
  std::vector<std::vector<double>> rows;
  for (const FrictionRow& row : table.rows) rows.push_back({row.speed_rad_s, row.friction_Nm});
  return rows;
}

}  // namespace

std::string matlab_file(const ArchivedJoint& joint) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  const calibration::Facts& f = joint.entry.facts;
  MatVariables file;
  std::string about;
  for (const std::string& line : comment_lines(joint)) about += line + "\n";
  file.add("about", about);
  file.add("id", joint.entry.id);
  file.add("robot", f.of.robot);
  file.add("serial", f.of.serial);
  file.add("joint", f.of.joint);
  file.add("measured_at", f.measured_at);
  file.add("verdict", calibration::to_string(f.verdict));
  file.add("gear_ratio", f.gear_ratio);
  for (const calibration::SidedQuantity& sided :
       calibration::on_both_sides(joint.quantities, f.gear_ratio)) {
    const calibration::Quantity& q = sided.quantity;
    const std::string name = q.name + "_" + joint::to_string(sided.side);
    const auto& e = q.estimate;
    file.add_rows(name, {{e ? e->value : nothing, e ? e->low : nothing, e ? e->high : nothing}});
    file.add(name + "_unit", q.unit);
    file.add(name + "_verdict", calibration::to_string(q.verdict));
  }
  const FrictionTable curve = friction_table(joint);
  if (!curve.rows.empty()) {
    file.add_rows("friction_curve_motor", matrix_of(curve));
    file.add_rows("friction_curve_joint", matrix_of(at_joint(curve, f.gear_ratio)));
    file.add("friction_curve_source", curve.source);
    if (joint.is_in_amperes()) file.add("friction_curve_torque_unit", "A");
  }
  return file.bytes();
}

}  // namespace tribolog::exports::results
