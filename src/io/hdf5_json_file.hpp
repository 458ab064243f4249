#pragma once
/// \file
/// The content of an HDF5 file (groups, numbers and texts) as JSON, in the hdf5-json layout of the HDF Group,
/// which Scalismo reads and writes. The classes have the same members as H5Writer and H5Reader, so that one
/// template serves both formats.

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/hdf5_file.hpp"

namespace foramen {

/// T is float, double or std::int32_t throughout. Identifiers of objects are hashes of their paths, so the
/// same values give the same text.
class H5JsonWriter {
 public:
  H5JsonWriter();

  void group(const std::string& path);
  template <class T>
  void scalar(const std::string& path, T value);
  template <class T>
  void vector(const std::string& path, std::span<const T> values);
  /// Throws InvalidInput unless there are rows * cols values.
  template <class T>
  void matrix(const std::string& path, const H5Matrix<T>& values);
  /// Throws InvalidInput if the text is not UTF-8.
  void string(const std::string& path, std::string_view text);
  /// A text attribute of an existing group. It is SCALAR, because Scalismo does not read a text from a list
  /// of one.
  void attribute(const std::string& path, const std::string& name, std::string_view text);
  /// The text of the file written so far.
  std::string text() const;

 private:
  struct Object {
    bool is_group = true;
    std::string shape, type, value;       ///< JSON, of a dataset
    std::vector<std::string> attributes;  ///< JSON objects, of a group
  };
  void dataset(const std::string& path, Object object);

  std::map<std::string, Object> objects_;  // by path; the path of the root is empty
};

/// Every member throws IoError with the file, the path and what was found.
class H5JsonReader {
 public:
  explicit H5JsonReader(const std::filesystem::path& path);
  ~H5JsonReader();
  H5JsonReader(const H5JsonReader&) = delete;
  H5JsonReader& operator=(const H5JsonReader&) = delete;

  bool has(const std::string& path) const;
  /// Names in a group, in alphabetical order.
  std::vector<std::string> children(const std::string& group) const;
  /// One number, or a list of one number. An integer is read only from a number without fraction.
  template <class T>
  T scalar(const std::string& path) const;
  template <class T>
  std::vector<T> vector(const std::string& path) const;
  template <class T>
  H5Matrix<T> matrix(const std::string& path) const;
  std::string string(const std::string& path) const;
  std::string attribute(const std::string& path, const std::string& name) const;
  [[noreturn]] void refuse(const std::string& path, const std::string& found) const;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace foramen
