#pragma once
// The bytes of a MAT file, and whether a variable holds what its header claims.

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include <zlib.h>

namespace tribolog::ingest::arrays {

/// A file read at any place.
class MatBytes {
 public:
  explicit MatBytes(const std::string& path);
  /// Up to `count` bytes from there.
  std::string at(std::uint64_t offset, std::size_t count);
  [[nodiscard]] std::uint64_t size() const { return size_; }

 private:
  std::ifstream in_;
  std::uint64_t size_{};
};

/// A stretch of a file from its first byte to its last, unpacked where it is packed.
class MatStream {
 public:
  MatStream(MatBytes& file, std::uint64_t offset, std::uint64_t length, bool is_packed);
  ~MatStream();
  MatStream(const MatStream&) = delete;
  MatStream& operator=(const MatStream&) = delete;

  /// Up to `count` bytes: fewer only where they end.
  std::string read(std::size_t count);
  /// @return how many of `count` there were to pass over.
  std::uint64_t skip(std::uint64_t count);
  /// Passes over the rest. @return whether what is packed is whole and has the right checksum.
  bool finish();

 private:
  void fill();
  void unpack();

  MatBytes& file_;
  std::uint64_t offset_;
  std::uint64_t left_;
  bool is_packed_;
  int status_{Z_OK};
  z_stream zlib_{};
  std::string packed_;
  std::string ready_;
  std::size_t used_{0};  ///< Of `ready_`.
};

// Whether a variable of a MAT 5 file holds what its header claims.

/// The objects of MATLAB's classes that a variable is, or holds.
struct MatObjects {
  std::string variable;              ///< Its name.
  bool is_object{};                  ///< It is one itself.
  std::vector<std::string> classes;  ///< Of each object, in their order; empty: it has none.
};

/// Walks a variable and all within it, from its own tag on. The library makes room for what the
/// headers claim, and gives zeros for what is not there.
/// @return "", or what is wrong with it: fewer values than its sides claim, a part longer than what
///         holds it, no array, nested too deeply.
/// @param objects receives what there is of them.
std::string check_mat_matrix(MatStream& stream, bool big_endian, MatObjects& objects);

}  // namespace tribolog::ingest::arrays
