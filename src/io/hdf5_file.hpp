#pragma once
/// \file
/// HDF5 files of ours and of others: few kinds of content, written so that the same values give the same
/// bytes (no times, contiguous, a layout that HDF5 1.8 and jHDF read), and read with every size checked
/// before memory is taken.
///
/// The HDF5 library is not safe to use from several threads at once, not even on different files: use these
/// classes, and read_statismo and write_statismo, from one thread at a time.
///
/// Paths are absolute ("/model/mean"); missing groups on the way are made. All numbers are stored little
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

/// Row by row in double precision, and back.
H5Matrix<double> h5_matrix(const Eigen::MatrixXd& matrix);
Eigen::MatrixXd eigen_matrix(const H5Matrix<double>& matrix);
Eigen::MatrixXd eigen_matrix(const H5Matrix<float>& matrix);

/// T is float, double or std::int32_t throughout.
class H5Writer {
 public:
  /// A file in memory; the path names it in errors. Throws IoError, as all members do when HDF5 refuses.
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
  /// Dataspace SCALAR, fixed length with the final NUL; ASCII, or UTF-8 where the text is not. Throws
  /// InvalidInput if the text holds a NUL.
  void string(const std::string& path, std::string_view text);
  /// Rank 1, all as long as the longest.
  void strings(const std::string& path, std::span<const std::string> texts);
  /// A string attribute of an existing group or dataset. Dataspace SIMPLE (1), fixed length, NUL at its end.
  void attribute(const std::string& path, const std::string& name, std::string_view text);
  /// The file as it stands.
  std::string bytes() const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

/// Calls `write` with a writer and puts what it has written in its place, whole or not at all (write_file()).
void write_h5(const std::filesystem::path& path, const std::function<void(H5Writer&)>& write);

/// Every member throws IoError naming file, path and what was found: not there, another kind, rank or type, a
/// size that the file cannot hold, links and data that lead out of the file.
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
  /// One number: SCALAR or of one element. Integers are never read from floating point numbers; what does not
  /// fit T is clipped.
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
  /// "file: path: found; remedy", for callers that find the content wanting.
  [[noreturn]] void refuse(const std::string& path, const std::string& found) const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

namespace io_detail {
/// Calls `read` in a copy of this process and throws IoError if that crashes or takes more seconds of the
/// processor. An exception of `read` is neither.
void require_survival(const std::filesystem::path& path, const std::function<void()>& read,
                      int most_seconds = 60);
}  // namespace io_detail

/// What `read` returns, called with a reader of the file. On some damaged files the HDF5 library crashes or
/// never ends, so `read` is called in a process of its own before, and the file is refused (IoError) if that
/// does not survive. \pre `read` has no effect but its result
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
