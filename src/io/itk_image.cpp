#ifdef FORAMEN_WITH_ITK
#include "io/itk_image.hpp"

#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "foramen/core/error.hpp"

namespace foramen::io_detail {
namespace {

class Reading {
 public:
  Reading(const std::filesystem::path& path, ImageFormat format) : name_(path.string()) {
    itk::Object::GlobalWarningDisplayOff();
    switch (format) {
      case ImageFormat::nifti:
        reader_ = itk::NiftiImageIO::New().GetPointer();
        break;
      case ImageFormat::nrrd:
        reader_ = itk::NrrdImageIO::New().GetPointer();
        break;
      case ImageFormat::meta:
        reader_ = itk::MetaImageIO::New().GetPointer();
        break;
    }
    reader_->SetFileName(name_);
    in_itk([&] { reader_->ReadImageInformation(); });
  }

  void require_size(const std::array<std::int64_t, 3>& size) {
    const unsigned dimensions = reader_->GetNumberOfDimensions();
    bool same = dimensions >= 3 && reader_->GetNumberOfComponents() == 1;
    itk::ImageIORegion region(dimensions);
    for (unsigned d = 0; d < dimensions; ++d) {
      same = same && static_cast<std::int64_t>(reader_->GetDimensions(d)) == (d < 3 ? size[d] : 1);
      region.SetSize(d, reader_->GetDimensions(d));
    }
    if (!same) refuse("ITK understands its header otherwise than foramen does", damaged);
    reader_->SetIORegion(region);
  }

  ItkImage read() {
    ItkImage image;
    for (std::size_t d = 0; d < 3; ++d) {
      const auto axis = static_cast<unsigned>(d);
      const std::vector<double> direction = reader_->GetDirection(axis);
      std::copy_n(direction.begin(), 3, image.direction[d].begin());
      image.spacing[d] = reader_->GetSpacing(axis);
      image.origin[d] = reader_->GetOrigin(axis);
    }
    std::vector<char> bytes(static_cast<std::size_t>(reader_->GetImageSizeInBytes()));
    in_itk([&] { reader_->Read(bytes.data()); });
    image.labels = as_labels(bytes);
    return image;
  }

 private:
  static constexpr const char* damaged = "the file is damaged or was cut off: export or copy it again";

  [[noreturn]] void refuse(const std::string& found, const std::string& remedy) const {
    throw IoError(name_ + ": " + found + "; " + remedy);
  }

  // Runs a step of the library, whose exceptions become ours.
  template <class Step>
  void in_itk(const Step& step) const {
    try {
      step();
    } catch (const itk::ExceptionObject& e) {
      std::string reason = e.GetDescription();
      for (char& c : reason)
        if (c < ' ' || c > '~') c = ' ';
      refuse("ITK cannot read it (" + reason + ")", damaged);
    }
  }

  template <class T>
  std::vector<std::uint16_t> labels_from(const std::vector<char>& bytes) const {
    constexpr double largest = std::numeric_limits<std::uint16_t>::max();
    std::vector<std::uint16_t> labels(bytes.size() / sizeof(T));
    for (std::size_t v = 0; v < labels.size(); ++v) {
      T raw;
      std::memcpy(&raw, bytes.data() + v * sizeof(T), sizeof(T));
      const auto value = static_cast<double>(raw);
      if (!(value >= 0 && value <= largest && value == std::floor(value)))
        refuse("a voxel has the value " + std::to_string(value) + ", which is no label (whole, 0 to 65535)",
               "give the label map, not the image or probabilities");
      labels[v] = static_cast<std::uint16_t>(value);
    }
    return labels;
  }

  std::vector<std::uint16_t> as_labels(const std::vector<char>& bytes) const {
    using Component = itk::IOComponentEnum;
    switch (reader_->GetComponentType()) {
      case Component::UCHAR:
        return labels_from<unsigned char>(bytes);
      case Component::CHAR:
        return labels_from<signed char>(bytes);
      case Component::USHORT:
        return labels_from<unsigned short>(bytes);
      case Component::SHORT:
        return labels_from<short>(bytes);
      case Component::UINT:
        return labels_from<unsigned int>(bytes);
      case Component::INT:
        return labels_from<int>(bytes);
      case Component::ULONG:
        return labels_from<unsigned long>(bytes);
      case Component::LONG:
        return labels_from<long>(bytes);
      case Component::ULONGLONG:
        return labels_from<unsigned long long>(bytes);
      case Component::LONGLONG:
        return labels_from<long long>(bytes);
      case Component::FLOAT:
        return labels_from<float>(bytes);
      case Component::DOUBLE:
        return labels_from<double>(bytes);
      default:
        refuse("its voxels are of a type that ITK calls " +
                   itk::ImageIOBase::GetComponentTypeAsString(reader_->GetComponentType()),
               "save it with whole numbers of 8 or 16 bits");
    }
  }

  std::string name_;
  itk::ImageIOBase::Pointer reader_;
};

}  // namespace

ItkImage read_with_itk(const std::filesystem::path& path, ImageFormat format,
                       const std::array<std::int64_t, 3>& size) {
  Reading reading(path, format);
  reading.require_size(size);
  return reading.read();
}

}  // namespace foramen::io_detail
#endif
