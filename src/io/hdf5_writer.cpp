#include <algorithm>
#include <array>
#include <atomic>

#include "foramen/core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/hdf5_file.hpp"
#include "io/hdf5_handle.hpp"

namespace foramen {

using io_detail::H5Handle;
using io_detail::H5Silence;

namespace io_detail {

std::string h5_memory_name() {
  static std::atomic<unsigned> counter{0};
  return "/dev/null/" + std::to_string(counter++);
}

std::string h5_reason() {
  std::string reason;
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned, const H5E_error2_t* error, void* out) -> herr_t {
        auto& text = *static_cast<std::string*>(out);
        if (text.empty() && error->desc) text = error->desc;
        return 0;
      },
      &reason);
  return reason.empty() ? "no reason given" : reason;
}

}  // namespace io_detail

struct H5Writer::File {
  std::string name;
  H5Handle id;

  [[noreturn]] void fail(const std::string& path) const {
    throw IoError(name + ": " + path + " cannot be written (HDF5: " + io_detail::h5_reason() +
                  "); is there enough memory?");
  }
  const H5Handle& checked(const H5Handle& handle, const std::string& path) const {
    if (!handle.valid()) fail(path);
    return handle;
  }

  void make_parents(const std::string& path) {
    for (auto at = path.find('/', 1); at != std::string::npos; at = path.find('/', at + 1))
      make_group(path.substr(0, at));
  }
  void make_group(const std::string& path) {
    if (H5Lexists(id, path.c_str(), H5P_DEFAULT) > 0) return;
    const H5Handle properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
    H5Pset_obj_track_times(properties, false);
    checked(H5Handle(H5Gcreate2(id, path.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT), H5Gclose), path);
  }

  void dataset(const std::string& path, hid_t file_type, hid_t memory_type, hid_t space, const void* values) {
    make_parents(path);
    const H5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_obj_track_times(properties, false);
    H5Pset_layout(properties, H5D_CONTIGUOUS);
    const H5Handle set(H5Dcreate2(id, path.c_str(), file_type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
                       H5Dclose);
    if (H5Dwrite(checked(set, path), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0) fail(path);
  }
};

namespace {

// The file is made in memory, because HDF5 1.10 crashes when the disk is full.
H5Handle create_file(const std::filesystem::path& path) {
  const H5Silence silence;
  const H5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_core(access, io_detail::h5_memory_step, false);
  H5Pset_libver_bounds(access, H5F_LIBVER_EARLIEST, H5F_LIBVER_V18);
  const H5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation, false);
  H5Handle file(H5Fcreate(io_detail::h5_memory_name().c_str(), H5F_ACC_TRUNC, creation, access), H5Fclose);
  if (!file.valid())
    throw IoError(path.string() + ": cannot be begun in memory (HDF5: " + io_detail::h5_reason() + ")");
  return file;
}

bool is_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; });
}

H5Handle string_type(std::size_t length, bool ascii) {
  H5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, length + 1);
  H5Tset_strpad(type, H5T_STR_NULLTERM);
  H5Tset_cset(type, ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8);
  return type;
}

void check_text(const std::string& path, std::string_view text) {
  if (text.find('\0') != std::string_view::npos)
    throw InvalidInput("cannot write " + path + ": its text holds a NUL");
}

}  // namespace

H5Matrix<double> h5_matrix(const Eigen::MatrixXd& matrix) {
  H5Matrix<double> out{static_cast<std::size_t>(matrix.rows()), static_cast<std::size_t>(matrix.cols()), {}};
  out.values.reserve(out.rows * out.cols);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) out.values.push_back(matrix(i, j));
  return out;
}

namespace {

template <class T>
Eigen::MatrixXd to_eigen(const H5Matrix<T>& matrix) {
  Eigen::MatrixXd out(static_cast<Eigen::Index>(matrix.rows), static_cast<Eigen::Index>(matrix.cols));
  for (std::size_t i = 0; i < matrix.rows; ++i)
    for (std::size_t j = 0; j < matrix.cols; ++j)
      out(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          static_cast<double>(matrix.values[i * matrix.cols + j]);
  return out;
}

}  // namespace

Eigen::MatrixXd eigen_matrix(const H5Matrix<double>& matrix) { return to_eigen(matrix); }
Eigen::MatrixXd eigen_matrix(const H5Matrix<float>& matrix) { return to_eigen(matrix); }

H5Writer::H5Writer(const std::filesystem::path& path) : file_(new File{path.string(), create_file(path)}) {}

H5Writer::~H5Writer() {
  const H5Silence silence;
  file_.reset();
}

void H5Writer::group(const std::string& path) {
  const H5Silence silence;
  file_->make_parents(path);
  file_->make_group(path);
}

template <class T>
void H5Writer::scalar(const std::string& path, T value) {
  const H5Silence silence;
  const H5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  file_->dataset(path, io_detail::h5_file_type<T>(), io_detail::h5_memory_type<T>(), space, &value);
}

template <class T>
void H5Writer::vector(const std::string& path, std::span<const T> values) {
  const H5Silence silence;
  const hsize_t size = values.size();
  const H5Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  file_->dataset(path, io_detail::h5_file_type<T>(), io_detail::h5_memory_type<T>(), space, values.data());
}

template <class T>
void H5Writer::matrix(const std::string& path, const H5Matrix<T>& values) {
  if (values.values.size() != values.rows * values.cols)
    throw InvalidInput("cannot write " + path + ": " + std::to_string(values.values.size()) + " values for " +
                       std::to_string(values.rows) + " x " + std::to_string(values.cols));
  const H5Silence silence;
  const std::array<hsize_t, 2> sizes{values.rows, values.cols};
  const H5Handle space(H5Screate_simple(2, sizes.data(), nullptr), H5Sclose);
  file_->dataset(path, io_detail::h5_file_type<T>(), io_detail::h5_memory_type<T>(), space,
                 values.values.data());
}

void H5Writer::string(const std::string& path, std::string_view text) {
  check_text(path, text);
  const H5Silence silence;
  const H5Handle type = string_type(text.size(), is_ascii(text)), space(H5Screate(H5S_SCALAR), H5Sclose);
  const std::string terminated(text);
  file_->dataset(path, type, type, space, terminated.c_str());
}

void H5Writer::strings(const std::string& path, std::span<const std::string> texts) {
  std::size_t longest = 0;
  bool ascii = true;
  for (const std::string& text : texts) {
    check_text(path, text);
    longest = std::max(longest, text.size());
    ascii = ascii && is_ascii(text);
  }
  std::string block;  // each text padded with NULs to the length of the longest plus one
  for (const std::string& text : texts) block.append(text).append(longest + 1 - text.size(), '\0');
  const H5Silence silence;
  const hsize_t size = texts.size();
  const H5Handle type = string_type(longest, ascii), space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  file_->dataset(path, type, type, space, block.data());
}

void H5Writer::attribute(const std::string& path, const std::string& name, std::string_view text) {
  check_text(path, text);
  const H5Silence silence;
  const hsize_t one = 1;
  const H5Handle type = string_type(text.size(), is_ascii(text)),
                 space(H5Screate_simple(1, &one, nullptr), H5Sclose);
  const H5Handle object(H5Oopen(file_->id, path.c_str(), H5P_DEFAULT), H5Oclose);
  const H5Handle attribute(
      H5Acreate2(file_->checked(object, path), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  const std::string terminated(text);
  if (H5Awrite(file_->checked(attribute, path), type, terminated.c_str()) < 0) file_->fail(path);
}

std::string H5Writer::bytes() const {
  const H5Silence silence;
  if (H5Fflush(file_->id, H5F_SCOPE_GLOBAL) < 0) file_->fail("its end");
  const ssize_t size = H5Fget_file_image(file_->id, nullptr, 0);
  std::string image(static_cast<std::size_t>(std::max<ssize_t>(size, 0)), '\0');
  if (size <= 0 || H5Fget_file_image(file_->id, image.data(), image.size()) != size) file_->fail("its image");
  return image;
}

void write_h5(const std::filesystem::path& path, const std::function<void(H5Writer&)>& write) {
  H5Writer writer(path);
  write(writer);
  write_file(path, writer.bytes());
}

template void H5Writer::scalar<float>(const std::string&, float);
template void H5Writer::scalar<double>(const std::string&, double);
template void H5Writer::scalar<std::int32_t>(const std::string&, std::int32_t);
template void H5Writer::vector<float>(const std::string&, std::span<const float>);
template void H5Writer::vector<double>(const std::string&, std::span<const double>);
template void H5Writer::vector<std::int32_t>(const std::string&, std::span<const std::int32_t>);
template void H5Writer::matrix<float>(const std::string&, const H5Matrix<float>&);
template void H5Writer::matrix<double>(const std::string&, const H5Matrix<double>&);
template void H5Writer::matrix<std::int32_t>(const std::string&, const H5Matrix<std::int32_t>&);

}  // namespace foramen
