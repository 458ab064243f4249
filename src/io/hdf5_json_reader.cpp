#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <type_traits>
#include <utility>

#include "foramen/core/error.hpp"
#include "io/hdf5_json_file.hpp"
#include "io/json_text.hpp"

namespace foramen {

using nlohmann::ordered_json;

struct H5JsonReader::File {
  explicit File(const std::filesystem::path& path) : name(path.string()) {
    const std::string bytes = io_detail::read_bytes(path);
    document = io_detail::parse_json({name, bytes});
    add_groups(text_member(document, "root", "/"));
  }

  [[noreturn]] void refuse(const std::string& path, const std::string& found) const {
    throw IoError(name + ": " + path + ": " + found +
                  "; the file is damaged or of another kind: export it again");
  }

  // The member `key` of an object; refuses the file if there is none.
  const ordered_json& member(const ordered_json& object, const char* key, const std::string& path) const {
    if (!object.is_object() || !object.contains(key))
      refuse(path, std::string("has no ") + key + ", as HDF5 in JSON would have");
    return object.at(key);
  }

  std::string text_member(const ordered_json& object, const char* key, const std::string& path) const {
    const ordered_json& text = member(object, key, path);
    if (!text.is_string()) refuse(path, std::string("its ") + key + " is no text");
    return text.get<std::string>();
  }

  // Follows the links from the root. A group that is linked twice is refused, so cyclic links cannot loop for
  // ever.
  void add_groups(const std::string& root) {
    const ordered_json& groups = member(document, "groups", "/");
    std::set<std::string> seen;
    std::vector<std::pair<std::string, std::string>> waiting{{"", root}};  // path, identifier
    while (!waiting.empty()) {
      const auto [path, id] = std::move(waiting.back());
      waiting.pop_back();
      if (!seen.insert(id).second) refuse(path, "is a group that is linked twice");
      if (path.size() > longest_path) refuse(path.substr(0, 40) + "...", "lies too deep");
      objects[path] = &member(groups, id.c_str(), path.empty() ? "/" : path);
      for (const auto& [title, link] : links_of(*objects[path], path)) {
        const std::string inner = path + "/" + title;
        if (text_member(*link, "collection", path) == "groups")
          waiting.emplace_back(inner, text_member(*link, "id", path));
        else
          objects[inner] =
              &member(member(document, "datasets", "/"), text_member(*link, "id", path).c_str(), inner);
      }
    }
  }

  std::vector<std::pair<std::string, const ordered_json*>> links_of(const ordered_json& group,
                                                                    const std::string& path) const {
    std::vector<std::pair<std::string, const ordered_json*>> links;
    if (!group.is_object() || !group.contains("links")) return links;
    if (!group.at("links").is_array()) refuse(path, "its links are no list");
    for (const ordered_json& link : group.at("links"))
      links.emplace_back(text_member(link, "title", path), &link);
    return links;
  }

  const ordered_json& object(const std::string& path) const {
    const auto found = objects.find(path);
    if (found == objects.end()) refuse(path, "is missing");
    return *found->second;
  }

  const ordered_json& value(const std::string& path) const { return member(object(path), "value", path); }

  template <class T>
  T number(const ordered_json& json, const std::string& path) const {
    if (!json.is_number()) refuse(path, "holds something that is no number");
    const double wide = json.get<double>();
    if constexpr (std::is_integral_v<T>) {
      // Some writers put 3.0 for the integer 3.
      if (!(wide >= std::numeric_limits<T>::min() && wide <= std::numeric_limits<T>::max()) ||
          wide != std::floor(wide))
        refuse(path, "holds a number that is no integer of 32 bits");
    }
    return static_cast<T>(wide);
  }

  template <class T>
  void append_list(std::vector<T>& out, const ordered_json& list, const std::string& path) const {
    if (!list.is_array()) refuse(path, "is no list of numbers");
    for (const ordered_json& item : list) out.push_back(number<T>(item, path));
  }

  // Refuses a dataset whose value does not have the sizes that its shape states.
  void check_shape(const std::string& path, const std::vector<std::size_t>& sizes) const {
    const ordered_json& shape = member(object(path), "shape", path);
    const ordered_json& dims = member(shape, "dims", path);
    if (dims != ordered_json(sizes)) refuse(path, "has another shape than it says");
  }

  std::string one_text(const ordered_json& json, const std::string& path) const {
    const ordered_json& text = json.is_array() && json.size() == 1 ? json.front() : json;
    if (!text.is_string()) refuse(path, "is not one text");
    return text.get<std::string>();
  }

  static constexpr std::size_t longest_path = 1000;
  std::string name;
  ordered_json document;
  std::map<std::string, const ordered_json*> objects;  // by path; the path of the root is empty
};

H5JsonReader::H5JsonReader(const std::filesystem::path& path) : file_(std::make_unique<File>(path)) {}
H5JsonReader::~H5JsonReader() = default;

bool H5JsonReader::has(const std::string& path) const { return file_->objects.contains(path); }

std::vector<std::string> H5JsonReader::children(const std::string& group) const {
  file_->object(group);
  std::vector<std::string> names;
  const std::string prefix = group + "/";
  for (auto at = file_->objects.lower_bound(prefix);
       at != file_->objects.end() && at->first.starts_with(prefix); ++at)
    if (at->first.find('/', prefix.size()) == std::string::npos)
      names.push_back(at->first.substr(prefix.size()));
  return names;
}

template <class T>
T H5JsonReader::scalar(const std::string& path) const {
  const ordered_json& value = file_->value(path);
  return file_->number<T>(value.is_array() && value.size() == 1 ? value.front() : value, path);
}

template <class T>
std::vector<T> H5JsonReader::vector(const std::string& path) const {
  std::vector<T> values;
  file_->append_list(values, file_->value(path), path);
  file_->check_shape(path, {values.size()});
  return values;
}

template <class T>
H5Matrix<T> H5JsonReader::matrix(const std::string& path) const {
  const ordered_json& rows = file_->value(path);
  if (!rows.is_array() || rows.empty()) file_->refuse(path, "is no list of rows");
  H5Matrix<T> matrix{rows.size(), rows.front().size(), {}};
  for (const ordered_json& row : rows) {
    if (row.size() != matrix.cols) file_->refuse(path, "has rows of different lengths");
    file_->append_list(matrix.values, row, path);
  }
  file_->check_shape(path, {matrix.rows, matrix.cols});
  return matrix;
}

std::string H5JsonReader::string(const std::string& path) const {
  return file_->one_text(file_->value(path), path);
}

std::string H5JsonReader::attribute(const std::string& path, const std::string& name) const {
  const ordered_json& object = file_->object(path);
  if (object.contains("attributes") && object.at("attributes").is_array())
    for (const ordered_json& attribute : object.at("attributes"))
      if (file_->text_member(attribute, "name", path) == name)
        return file_->one_text(file_->member(attribute, "value", path), path + "@" + name);
  file_->refuse(path + "@" + name, "is missing");
}

void H5JsonReader::refuse(const std::string& path, const std::string& found) const {
  file_->refuse(path, found);
}

template float H5JsonReader::scalar(const std::string&) const;
template double H5JsonReader::scalar(const std::string&) const;
template std::int32_t H5JsonReader::scalar(const std::string&) const;
template std::vector<float> H5JsonReader::vector(const std::string&) const;
template std::vector<double> H5JsonReader::vector(const std::string&) const;
template std::vector<std::int32_t> H5JsonReader::vector(const std::string&) const;
template H5Matrix<float> H5JsonReader::matrix(const std::string&) const;
template H5Matrix<double> H5JsonReader::matrix(const std::string&) const;
template H5Matrix<std::int32_t> H5JsonReader::matrix(const std::string&) const;

}  // namespace foramen
