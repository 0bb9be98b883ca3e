#pragma once
// One NumPy array: the Python text of its header, the type that it states, and its values.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/arrays/array_tables.h"

namespace tribolog::ingest::arrays {

// Text of Python literals, as a NumPy header holds them: taken piece by piece from the front.

class PythonText {
 public:
  explicit PythonText(std::string_view text) : rest_(text) {}

  /// Each takes what it names, with blanks in front of it. @return false: it is not there, and what
  /// is left of the text has no meaning.
  bool take(char c);
  bool take(std::string_view word);
  /// In quotes of either kind, with Python's escapes.
  bool take_text(std::string& text);
  bool take_number(std::uint64_t& number);

  bool is_at_end();

 private:
  void skip_blanks();
  bool take_escape(std::string& text);
  std::string_view rest_;
};

// The header of a NumPy array: format versions 1 to 3, and the type of the elements that it
// states.

/// A dimension of an array: so many values, each so many bytes behind the one before.
struct NpyDimension {
  std::uint64_t size{};
  std::uint64_t stride{};
};

/// Numbers of one simple type in each element. Of nested records the innermost fields.
struct NpyField {
  std::string name;        ///< "q", nested "motor.q"; empty where the element is a plain number.
  std::string type;        ///< "<f8" as it stands.
  std::uint64_t offset{};  ///< In the element's bytes.
  std::vector<NpyDimension> within{};  ///< Of a field that is an array itself, last one fastest.
};

struct NpyType {
  std::vector<NpyField> fields;
  bool is_record{};
  std::uint64_t bytes{};  ///< Of one element; of no meaning where a field's size is not known.
};

/// Bytes of a simple type such as "<f8", "|S12", "<U3" or "<M8[ns]"; nullopt of those whose values
/// do not lie in the array, as objects, and of what is not known.
std::optional<std::uint64_t> bytes_of_type(const std::string& type);

/// Takes what stands behind 'descr': a simple type's text, or NumPy's list of fields, each with its
/// name (or title and name), its type and, of an array, its shape. Fields without a name of type V
/// are padding and left out.
/// @return nullopt where the text is no such type, or one nested or large beyond all use.
std::optional<NpyType> take_npy_type(PythonText& text);

/// Takes "(3, 4)", "(3,)" or "()". @return false where there is no such text.
bool take_npy_shape(PythonText& text, std::vector<std::uint64_t>& shape);

// The header of a NumPy array: format versions 1 to 3.

struct NpyHeader {
  NpyType type;
  bool fortran_order{};
  std::vector<std::uint64_t> shape;
  std::size_t bytes{};  ///< Where the values start.
};

/// @throw InputError saying what is wrong with the header of array `name`.
NpyHeader read_npy_header(std::string_view bytes, const std::string& name, const std::string& file);

// One NumPy array.

/// What the fields of an array of records are called.
enum class RecordNames {
  by_field,           ///< "q": where the array's name is only its file's.
  by_array_and_field  ///< "run.q"
};

/// Adds an array of numbers, booleans or times (datetime64 and timedelta64 in s, ms, us or ns, NaT
/// a gap), or a single text. Of an array of records each field is an array of its own, those of
/// nested records too; a field that is an array itself adds its dimensions. Objects, which are
/// pickles and could run code, complex numbers and texts are left out with the reason; with an
/// object in it, the whole array is one.
/// @throw InputError where the header is damaged, or the values are more or fewer than it says.
void add_npy_array(std::string_view bytes, const std::string& name, const std::string& file,
                   RecordNames names, FileArrays& found);

}  // namespace tribolog::ingest::arrays
