#pragma once
/// \file
/// Reads and writes the few kinds of HDF5 content that foramen uses. The same values always give the same
/// bytes: no time stamps, contiguous storage, a layout that HDF5 1.8 and jHDF read. The reader checks every
/// size before it allocates memory.
///
/// The HDF5 library is not thread-safe, not even for different files. Use these classes, read_statismo() and
/// write_statismo() from one thread at a time.
///
/// Paths are absolute ("/model/mean"); the writer creates the groups of a path. All numbers are stored little
/// endian.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace foramen {

/// A matrix of numbers, row by row.
template <class T>
struct H5Matrix {
  std::size_t rows = 0, cols = 0;
  std::vector<T> values;  ///< rows * cols, value (i, j) at i * cols + j
};

/// Conversion from an Eigen matrix, and back.
H5Matrix<double> h5_matrix(const Eigen::MatrixXd& matrix);
Eigen::MatrixXd eigen_matrix(const H5Matrix<double>& matrix);
Eigen::MatrixXd eigen_matrix(const H5Matrix<float>& matrix);

/// T is float, double or std::int32_t throughout.
class H5Writer {
 public:
  /// Begins a file in memory; the path serves for error messages only. All members throw IoError if the HDF5
  /// library reports an error.
  explicit H5Writer(const std::filesystem::path& path);
  ~H5Writer();
  H5Writer(const H5Writer&) = delete;
  H5Writer& operator=(const H5Writer&) = delete;

  void group(const std::string& path);
  /// Dataspace SCALAR.
  template <class T>
  void scalar(const std::string& path, T value);
  /// Rank 1.
  template <class T>
  void vector(const std::string& path, std::span<const T> values);
  /// Rank 2. Throws InvalidInput unless there are rows * cols values.
  template <class T>
  void matrix(const std::string& path, const H5Matrix<T>& values);
  /// Dataspace SCALAR, fixed length including the final NUL; marked as ASCII if the text is ASCII, otherwise
  /// as UTF-8. Throws InvalidInput if the text contains a NUL.
  void string(const std::string& path, std::string_view text);
  /// Rank 1; all elements have the length of the longest text.
  void strings(const std::string& path, std::span<const std::string> texts);
  /// A string attribute of an existing group or dataset. Dataspace SIMPLE (1), fixed length, NUL at its end.
  void attribute(const std::string& path, const std::string& name, std::string_view text);
  /// The bytes of the file written so far.
  std::string bytes() const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

/// Calls `write` with a writer and writes the finished file to `path` atomically (see write_file()).
void write_h5(const std::filesystem::path& path, const std::function<void(H5Writer&)>& write);

/// Every member throws IoError with the file, the path and what was found: a missing object, another kind,
/// rank or type, a size larger than the file can hold, or links and data that lead to another file.
class H5Reader {
 public:
  explicit H5Reader(const std::filesystem::path& path);
  ~H5Reader();
  H5Reader(const H5Reader&) = delete;
  H5Reader& operator=(const H5Reader&) = delete;

  bool has(const std::string& path) const;
  /// Names in a group, in alphabetical order.
  std::vector<std::string> children(const std::string& group) const;
  /// Sizes of a dataset; empty for SCALAR.
  std::vector<std::size_t> shape(const std::string& path) const;
  /// One number, from a SCALAR dataset or one of a single element. An integer is never read from
  /// floating-point data; a value out of the range of T is clipped to it.
  template <class T>
  T scalar(const std::string& path) const;
  template <class T>
  std::vector<T> vector(const std::string& path) const;
  template <class T>
  H5Matrix<T> matrix(const std::string& path) const;
  /// One string of fixed or variable length.
  std::string string(const std::string& path) const;
  std::vector<std::string> strings(const std::string& path) const;
  bool has_attribute(const std::string& path, const std::string& name) const;
  std::string attribute(const std::string& path, const std::string& name) const;
  /// Throws IoError "file: path: found; remedy", for callers that cannot use the content.
  [[noreturn]] void refuse(const std::string& path, const std::string& found) const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

namespace io_detail {
/// Calls `read` in a forked copy of this process. Throws IoError if the copy crashes or needs more than
/// `most_seconds` of CPU time. An exception thrown by `read` counts as survival.
void require_survival(const std::filesystem::path& path, const std::function<void()>& read,
                      int most_seconds = 60);
}  // namespace io_detail

/// Returns what `read` returns for a reader of the file. The HDF5 library crashes or never returns on some
/// damaged files, so `read` is first called in a process of its own; if that does not survive, the file is
/// refused (IoError). \pre `read` has no effect other than its result
template <class Read>
auto read_h5(const std::filesystem::path& path, const Read& read) {
  const auto open_and_read = [&] {
    const H5Reader file(path);
    return read(file);
  };
  io_detail::require_survival(path, open_and_read);
  return open_and_read();
}

}  // namespace foramen
