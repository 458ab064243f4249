#include "io/xlsx_sheet.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "io/xml_elements.hpp"
#include "io/zip_archive.hpp"

namespace foramen::io_detail {
namespace {

// Parts of other spreadsheets can be that large; a project of a thousand subjects has about 2 MiB.
constexpr std::uint64_t most_bytes = std::uint64_t{16} << 20U;

// The name without its prefix: some programs write <x:row> for <row>.
std::string_view local(std::string_view name) {
  const auto colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

const XmlElement* child(const XmlElement& parent, std::string_view name) {
  const auto found = std::find_if(parent.children.begin(), parent.children.end(),
                                  [&](const XmlElement& element) { return local(element.name) == name; });
  return found == parent.children.end() ? nullptr : &*found;
}

// The text of <si> or <is>, which is whole or in runs of different fonts. Readings (<rPh>) are no part.
std::string text_of(const XmlElement& item) {
  std::string text;
  for (const XmlElement& element : item.children)
    if (local(element.name) == "t")
      text += element.text;
    else if (local(element.name) == "r")
      text += text_of(element);
  return text;
}

// The letters of a cell's place: "AB" of "AB12".
std::string column_of(const std::string& place) { return place.substr(0, place.find_first_of("0123456789")); }

class Workbook {
 public:
  explicit Workbook(const Source& source) : source_(source), archive_(source, most_bytes) {}

  std::vector<SheetRow> rows(const std::string& sheet) {
    const XmlElement root = part(path_of(sheet));
    const XmlElement* data = child(root, "sheetData");
    if (const auto texts = archive_.file("xl/sharedStrings.xml")) {
      for (const XmlElement& item : parse_xml(source_, *texts).children)
        if (local(item.name) == "si") shared_texts_.push_back(text_of(item));
    }
    std::map<std::string, std::string> names;  // by column
    std::vector<SheetRow> rows;
    bool first = true;
    if (data != nullptr)
      for (const XmlElement& row : data->children) {
        if (local(row.name) != "row") continue;
        const auto cells = cells_of(row);
        if (std::exchange(first, false)) {
          names = cells;
          continue;
        }
        SheetRow named;
        for (const auto& [column, text] : cells)
          if (const auto name = names.find(column); name != names.end()) named[name->second] = text;
        if (!named.empty()) rows.push_back(std::move(named));
      }
    return rows;
  }

 private:
  XmlElement part(const std::string& name) {
    const auto bytes = archive_.file(name);
    if (!bytes) source_.refuse("is no spreadsheet (it has no part " + in_quotes(name) + ")", remedy);
    return parse_xml(source_, *bytes);
  }

  // The workbook names the sheets and gives each an id, and the relations say which part an id stands for.
  std::string path_of(const std::string& sheet) {
    const XmlElement book = part("xl/workbook.xml");
    std::optional<std::string> id;
    if (const XmlElement* sheets = child(book, "sheets"); sheets != nullptr)
      for (const XmlElement& element : sheets->children)
        if (element.attribute("name") == sheet)
          for (const auto& [key, value] : element.attributes)
            if (key.find(':') != std::string::npos && local(key) == "id") id = value;
    if (!id) source_.refuse("is a spreadsheet without a sheet " + in_quotes(sheet), remedy);
    for (const XmlElement& relation : part("xl/_rels/workbook.xml.rels").children) {
      if (relation.attribute("Id") != *id) continue;
      const std::string target = relation.attribute("Target");
      return target.starts_with('/') ? target.substr(1) : "xl/" + target;
    }
    source_.refuse("is a spreadsheet whose sheet " + in_quotes(sheet) + " is missing", remedy_export_again);
  }

  // The cells of a row that are not empty, by the letters of their columns. A cell without a place follows
  // the one before.
  std::map<std::string, std::string> cells_of(const XmlElement& row) {
    std::map<std::string, std::string> cells;
    std::string column;
    for (const XmlElement& cell : row.children) {
      if (local(cell.name) != "c") continue;
      const std::string place = cell.attribute("r");
      column = place.empty() ? next(column) : column_of(place);
      std::string text = text_in(cell);
      // Many cells may share one long text.
      used_ += text.size();
      if (used_ > most_bytes) source_.refuse("is too large when it is unpacked", remedy);
      if (!text.empty()) cells[column] = std::move(text);
    }
    return cells;
  }

  std::string text_in(const XmlElement& cell) const {
    const std::string type = cell.attribute("t");
    if (type == "inlineStr") {
      const XmlElement* text = child(cell, "is");
      return text == nullptr ? std::string() : text_of(*text);
    }
    const XmlElement* value = child(cell, "v");
    if (value == nullptr) return {};
    if (type != "s") return value->text;
    const auto index = to_integer(TokenCursor(value->text).rest());
    if (!index || *index < 0 || *index >= std::ssize(shared_texts_))
      source_.refuse(
          "a cell has text " + in_quotes(value->text) + " of " + std::to_string(shared_texts_.size()),
          remedy_export_again);
    return shared_texts_[*index];
  }

  // The letters of the column after that one: A after none, AA after Z.
  static std::string next(std::string column) {
    for (auto letter = column.rbegin(); letter != column.rend(); ++letter) {
      if (*letter != 'Z') {
        ++*letter;
        return column;
      }
      *letter = 'A';
    }
    return "A" + column;
  }

  static constexpr const char* remedy =
      "save the project as .swproj in ShapeWorks Studio, or a table of landmarks as .csv";
  const Source& source_;
  ZipArchive archive_;
  std::vector<std::string> shared_texts_;
  std::uint64_t used_ = 0;  // bytes of the texts of cells
};

}  // namespace

std::vector<SheetRow> read_sheet(const Source& source, const std::string& sheet) {
  return Workbook(source).rows(sheet);
}

}  // namespace foramen::io_detail
