#include <algorithm>
#include <limits>
#include <string_view>

#include "foramen/core/error.hpp"
#include "io/file_bytes.hpp"
#include "io/hdf5_file.hpp"
#include "io/hdf5_handle.hpp"

namespace foramen {

using io_detail::H5Handle;
using io_detail::H5Silence;

struct H5Reader::File {
  std::string name;
  std::uint64_t bytes;
  H5Handle id;

  [[noreturn]] void refuse(const std::string& path, const std::string& found) const {
    throw IoError(
        name + ": " + path + ": " + found +
        "; the file is damaged or not of the expected kind: write it again with the program that made it");
  }

  // Whether the object exists and is reached by hard links only. Soft and external links are not followed,
  // because they could lead to other files.
  bool has(const std::string& path) const {
    for (std::size_t at = path.find('/', 1);; at = path.find('/', at + 1)) {
      const std::string part = path.substr(0, at);
      if (part.size() > 1) {
        if (H5Lexists(id, part.c_str(), H5P_DEFAULT) <= 0) return false;
        H5L_info_t info{};
        if (H5Lget_info(id, part.c_str(), &info, H5P_DEFAULT) < 0) refuse(part, "a link that cannot be read");
        if (info.type != H5L_TYPE_HARD) refuse(part, "a symbolic or external link");
      }
      if (at == std::string::npos) return true;
    }
  }
  void need(const std::string& path) const {
    if (!has(path)) refuse(path, "is missing");
  }

  H5Handle open_dataset(const std::string& path) const {
    need(path);
    H5Handle set(H5Dopen2(id, path.c_str(), H5P_DEFAULT), H5Dclose);
    if (!set.valid()) refuse(path, "is no dataset that can be opened (HDF5: " + io_detail::h5_reason() + ")");
    const H5Handle properties(H5Dget_create_plist(set), H5Pclose);
    if (H5Pget_external_count(properties) > 0 || H5Pget_layout(properties) == H5D_VIRTUAL)
      refuse(path, "keeps its data in another file");
    return set;
  }

  std::vector<std::size_t> shape_of(hid_t space, const std::string& path) const {
    const int rank = H5Sget_simple_extent_ndims(space);
    if (rank < 0 || H5Sget_simple_extent_type(space) == H5S_NULL) refuse(path, "has no shape");
    std::vector<hsize_t> sizes(rank);
    if (rank > 0 && H5Sget_simple_extent_dims(space, sizes.data(), nullptr) < 0) refuse(path, "has no shape");
    return {sizes.begin(), sizes.end()};
  }

  // The number of elements; refuses a number that the file cannot hold.
  std::size_t checked_count(hid_t set, const std::vector<std::size_t>& shape, std::size_t element_bytes,
                            const std::string& path) const {
    if (element_bytes == 0) refuse(path, "has elements without a size");
    const H5Handle properties(H5Dget_create_plist(set), H5Pclose);
    // Chunks may be compressed. Deflate, the strongest filter in use, packs at most about 1032 bytes into
    // one.
    constexpr std::uint64_t densest = 1032;
    const std::uint64_t most =
        bytes * (H5Pget_layout(properties) == H5D_CHUNKED ? densest : 1) / element_bytes;
    std::uint64_t count = 1;
    for (std::size_t size : shape) {
      if (size > 0 && count > most / size)
        refuse(path,
               "its announced size is more than the file's " + std::to_string(bytes) + " bytes can hold");
      count *= size;
    }
    return count;
  }

  static std::string text_of(const std::vector<std::size_t>& shape) {
    std::string text;
    for (std::size_t size : shape) text += (text.empty() ? "" : " x ") + std::to_string(size);
    return "(" + text + ")";
  }

  void expect_rank(std::size_t rank, const std::vector<std::size_t>& shape, const std::string& path) const {
    if (shape.size() != rank)
      refuse(path, "has shape " + text_of(shape) + ", not rank " + std::to_string(rank));
  }

  template <class T>
  std::vector<T> numbers(const H5Handle& set, const std::vector<std::size_t>& shape,
                         const std::string& path) const {
    const H5Handle type(H5Dget_type(set), H5Tclose);
    const H5T_class_t kind = H5Tget_class(type);
    const bool fits = kind == H5T_INTEGER || (kind == H5T_FLOAT && !std::is_integral_v<T>);
    if (!fits) refuse(path, std::is_integral_v<T> ? "holds no integers" : "holds no numbers");
    std::vector<T> values(checked_count(set, shape, H5Tget_size(type), path));
    if (!values.empty() &&
        H5Dread(set, io_detail::h5_memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
      refuse(path, "its values cannot be read (HDF5: " + io_detail::h5_reason() + ")");
    return values;
  }

  // Reads strings through `read(memory_type, buffer)`, which calls one of the two read functions of HDF5 (for
  // datasets and for attributes).
  template <class Read>
  std::vector<std::string> texts(hid_t type, hid_t space, std::size_t count, const std::string& path,
                                 const Read& read) const {
    if (H5Tget_class(type) != H5T_STRING) refuse(path, "holds no text");
    std::vector<std::string> out;
    const H5Handle memory(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_cset(memory, H5Tget_cset(type));
    const auto check = [&](herr_t status) {
      if (status < 0) refuse(path, "its text cannot be read (HDF5: " + io_detail::h5_reason() + ")");
    };
    if (H5Tis_variable_str(type) > 0) {
      H5Tset_size(memory, H5T_VARIABLE);
      std::vector<char*> pointers(count, nullptr);
      check(read(memory, pointers.data()));
      for (const char* text : pointers) out.emplace_back(text ? text : "");
      H5Dvlen_reclaim(memory, space, H5P_DEFAULT, pointers.data());
      return out;
    }
    const std::size_t length = H5Tget_size(type);
    if (length > bytes) refuse(path, "its text is longer than the file");
    H5Tset_size(memory, length + 1);  // room for a NUL, however the file pads strings
    std::string block(count * (length + 1), '\0');
    check(read(memory, block.data()));
    for (std::size_t i = 0; i < count; ++i) {
      std::string text = block.substr(i * (length + 1), length);
      if (H5Tget_strpad(type) == H5T_STR_SPACEPAD) text.erase(text.find_last_not_of(' ') + 1);
      out.push_back(text.substr(0, text.find('\0')));
    }
    return out;
  }

  std::vector<std::string> dataset_texts(const std::string& path, std::vector<std::size_t>& shape) const {
    const H5Handle set = open_dataset(path), space(H5Dget_space(set), H5Sclose),
                   type(H5Dget_type(set), H5Tclose);
    shape = shape_of(space, path);
    const std::size_t count = checked_count(set, shape, std::max<std::size_t>(1, H5Tget_size(type)), path);
    return texts(type, space, count, path, [&](hid_t memory, void* buffer) {
      return H5Dread(set, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer);
    });
  }
};

namespace {

// The signature stands at the beginning or after a user block of 512, 1024, 2048 ... bytes.
bool is_hdf5(std::string_view bytes) {
  constexpr std::string_view signature("\x89HDF\r\n\x1a\n", 8);
  for (std::size_t at = 0; at < bytes.size(); at = at == 0 ? 512 : 2 * at)
    if (bytes.substr(at).starts_with(signature)) return true;
  return false;
}

// HDF5 reads from a copy in memory, so a file that changes or a disk that fails while it reads cannot make it
// crash.
H5Handle open_file(const std::filesystem::path& path, std::string& bytes) {
  const H5Silence silence;
  if (!is_hdf5(bytes)) throw IoError(path.string() + ": is no HDF5 file; check its format and extension");
  const H5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_core(access, io_detail::h5_memory_step, false);
  H5Pset_file_image(access, bytes.data(), bytes.size());
  H5Handle file(H5Fopen(io_detail::h5_memory_name().c_str(), H5F_ACC_RDONLY, access), H5Fclose);
  if (!file.valid())
    throw IoError(path.string() + ": cannot be opened (HDF5: " + io_detail::h5_reason() +
                  "); the file is damaged or cut off: copy or write it again");
  return file;
}

}  // namespace

H5Reader::H5Reader(const std::filesystem::path& path) {
  std::string bytes = io_detail::read_bytes(path);
  file_.reset(new File{path.string(), bytes.size(), open_file(path, bytes)});
}

H5Reader::~H5Reader() {
  const H5Silence silence;
  file_.reset();
}

bool H5Reader::has(const std::string& path) const {
  const H5Silence silence;
  return file_->has(path);
}

std::vector<std::string> H5Reader::children(const std::string& group) const {
  const H5Silence silence;
  file_->need(group);
  const H5Handle id(H5Gopen2(file_->id, group.c_str(), H5P_DEFAULT), H5Gclose);
  if (!id.valid()) file_->refuse(group, "is no group");
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* out) -> herr_t {
    static_cast<std::vector<std::string>*>(out)->emplace_back(name);
    return 0;
  };
  if (H5Literate(id, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names) < 0)
    file_->refuse(group, "cannot be listed (HDF5: " + io_detail::h5_reason() + ")");
  return names;
}

std::vector<std::size_t> H5Reader::shape(const std::string& path) const {
  const H5Silence silence;
  const H5Handle set = file_->open_dataset(path), space(H5Dget_space(set), H5Sclose);
  return file_->shape_of(space, path);
}

template <class T>
T H5Reader::scalar(const std::string& path) const {
  const auto sizes = shape(path);
  const H5Silence silence;
  if (sizes.size() > 1 || (sizes.size() == 1 && sizes[0] != 1))
    file_->refuse(path, "has shape " + File::text_of(sizes) + ", not one value");
  return file_->numbers<T>(file_->open_dataset(path), sizes, path)[0];
}

template <class T>
std::vector<T> H5Reader::vector(const std::string& path) const {
  const auto sizes = shape(path);
  const H5Silence silence;
  file_->expect_rank(1, sizes, path);
  return file_->numbers<T>(file_->open_dataset(path), sizes, path);
}

template <class T>
H5Matrix<T> H5Reader::matrix(const std::string& path) const {
  const auto sizes = shape(path);
  const H5Silence silence;
  file_->expect_rank(2, sizes, path);
  return {sizes[0], sizes[1], file_->numbers<T>(file_->open_dataset(path), sizes, path)};
}

std::string H5Reader::string(const std::string& path) const {
  const H5Silence silence;
  std::vector<std::size_t> sizes;
  auto texts = file_->dataset_texts(path, sizes);
  if (texts.size() != 1) file_->refuse(path, "has shape " + File::text_of(sizes) + ", not one text");
  return texts[0];
}

std::vector<std::string> H5Reader::strings(const std::string& path) const {
  const H5Silence silence;
  std::vector<std::size_t> sizes;
  auto texts = file_->dataset_texts(path, sizes);
  file_->expect_rank(1, sizes, path);
  return texts;
}

bool H5Reader::has_attribute(const std::string& path, const std::string& name) const {
  const H5Silence silence;
  return file_->has(path) && H5Aexists_by_name(file_->id, path.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

std::string H5Reader::attribute(const std::string& path, const std::string& name) const {
  const std::string place = path + " attribute " + name;
  if (!has_attribute(path, name)) file_->refuse(place, "is missing");
  const H5Silence silence;
  const H5Handle attribute(H5Aopen_by_name(file_->id, path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose);
  if (!attribute.valid()) file_->refuse(place, "cannot be opened (HDF5: " + io_detail::h5_reason() + ")");
  const H5Handle space(H5Aget_space(attribute), H5Sclose), type(H5Aget_type(attribute), H5Tclose);
  for (std::size_t size : file_->shape_of(space, place))
    if (size != 1) file_->refuse(place, "is not one text");
  return file_->texts(type, space, 1, place,
                      [&](hid_t memory, void* buffer) { return H5Aread(attribute, memory, buffer); })[0];
}

void H5Reader::refuse(const std::string& path, const std::string& found) const { file_->refuse(path, found); }

template float H5Reader::scalar<float>(const std::string&) const;
template double H5Reader::scalar<double>(const std::string&) const;
template std::int32_t H5Reader::scalar<std::int32_t>(const std::string&) const;
template std::vector<float> H5Reader::vector<float>(const std::string&) const;
template std::vector<double> H5Reader::vector<double>(const std::string&) const;
template std::vector<std::int32_t> H5Reader::vector<std::int32_t>(const std::string&) const;
template H5Matrix<float> H5Reader::matrix<float>(const std::string&) const;
template H5Matrix<double> H5Reader::matrix<double>(const std::string&) const;
template H5Matrix<std::int32_t> H5Reader::matrix<std::int32_t>(const std::string&) const;

}  // namespace foramen
