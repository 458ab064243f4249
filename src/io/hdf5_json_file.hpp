#pragma once
/// \file
/// The contents of an HDF5 file as JSON, in the layout of the HDF Group's hdf5-json that Scalismo writes
/// beside HDF5: groups, numbers and texts. The same members as H5Writer and H5Reader, so that what is written
/// through one is written through the other.

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

/// T is float, double or std::int32_t throughout. Identifiers are made from paths: the same values give the
/// same text.
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
  /// A text of an existing group: SCALAR, since Scalismo takes no text from a list.
  void attribute(const std::string& path, const std::string& name, std::string_view text);
  /// The file as it stands.
  std::string text() const;

 private:
  struct Object {
    bool is_group = true;
    std::string shape, type, value;       ///< JSON, of a dataset
    std::vector<std::string> attributes;  ///< JSON objects, of a group
  };
  void dataset(const std::string& path, Object object);

  std::map<std::string, Object> objects_;  // by path; the root's is empty
};

/// Every member throws IoError naming file, path and what was found.
class H5JsonReader {
 public:
  explicit H5JsonReader(const std::filesystem::path& path);
  ~H5JsonReader();
  H5JsonReader(const H5JsonReader&) = delete;
  H5JsonReader& operator=(const H5JsonReader&) = delete;

  bool has(const std::string& path) const;
  /// Names in a group, in alphabetical order.
  std::vector<std::string> children(const std::string& group) const;
  /// One number, or a list of one. Integers are never read from other numbers.
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
