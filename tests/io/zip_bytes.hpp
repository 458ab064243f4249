#pragma once
/// \file
/// Zip archives, and spreadsheets in them, for tests.

#include <zlib.h>

#include <string>
#include <utility>
#include <vector>

#include "foramen/core/error.hpp"
#include "io/file_bytes.hpp"

namespace foramen::testing {

using ZipFiles = std::vector<std::pair<std::string, std::string>>;  // name and bytes

/// The bytes as deflate packs them, without the header of zlib.
inline std::string deflated(const std::string& bytes) {
  z_stream stream{};
  FORAMEN_ASSERT(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY) == Z_OK);
  std::string out(deflateBound(&stream, bytes.size()), '\0');
  std::string in = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  FORAMEN_ASSERT(deflate(&stream, Z_FINISH) == Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

inline std::string zip_bytes(const ZipFiles& files, bool deflate = true) {
  const auto numbers16 = [](std::string& out, std::initializer_list<unsigned> values) {
    for (const unsigned value : values)
      io_detail::append_little_endian(out, static_cast<std::uint16_t>(value));
  };
  const auto numbers32 = [](std::string& out, std::initializer_list<std::size_t> values) {
    for (const std::size_t value : values)
      io_detail::append_little_endian(out, static_cast<std::uint32_t>(value));
  };
  std::string out, list;
  for (const auto& [name, bytes] : files) {
    const std::string packed = deflate ? deflated(bytes) : bytes;
    std::string both;  // what the head of a file and its entry in the list have in common
    numbers16(both, {20, 0, deflate ? 8U : 0U, 0, 0});
    numbers32(both, {crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())),
                     packed.size(), bytes.size()});
    numbers16(both, {static_cast<unsigned>(name.size()), 0});
    list += std::string("PK\1\2", 4);
    numbers16(list, {20});
    list += both;
    numbers16(list, {0, 0, 0});
    numbers32(list, {0, out.size()});
    list += name;
    out += std::string("PK\3\4", 4) + both + name + packed;
  }
  const std::size_t list_at = out.size();
  out += list + std::string("PK\5\6", 4);
  const auto count = static_cast<unsigned>(files.size());
  numbers16(out, {0, 0, count, count});
  numbers32(out, {list.size(), list_at});
  numbers16(out, {0});
  return out;
}

/// The parts of a spreadsheet whose sheet "data" has these rows, with the texts that they share.
inline ZipFiles spreadsheet(const std::string& rows, const std::string& shared_texts = "") {
  const std::string head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>";
  return {{"xl/workbook.xml",
           head + "<workbook xmlns:r=\"u\"><sheets><sheet name=\"optimize\" sheetId=\"1\" r:id=\"rId1\"/>"
                  "<sheet name=\"data\" sheetId=\"2\" r:id=\"rId7\"/></sheets></workbook>"},
          {"xl/_rels/workbook.xml.rels",
           head + "<Relationships><Relationship Id=\"rId1\" Target=\"worksheets/sheet1.xml\"/>"
                  "<Relationship Id=\"rId7\" Target=\"/xl/worksheets/sheet2.xml\"/></Relationships>"},
          {"xl/worksheets/sheet1.xml", head + "<worksheet><sheetData/></worksheet>"},
          {"xl/worksheets/sheet2.xml", head + "<worksheet><sheetData>" + rows + "</sheetData></worksheet>"},
          {"xl/sharedStrings.xml", head + "<sst>" + shared_texts + "</sst>"}};
}

}  // namespace foramen::testing
