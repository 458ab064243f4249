#include "report/pdf_chart.hpp"

#include <cstdio>

#include "report/chart_drawing.hpp"
#include "report/plain_number.hpp"

namespace foramen {
namespace {

constexpr double font_size = 12;
constexpr std::uint32_t black = 0x000000, faint_ink = 0xE0E0E0;

// The widths of Helvetica's characters, beginning with the space, in thousandths of the font size (Adobe's
// font metrics).
constexpr std::array<int, 95> letter_widths{
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};
constexpr int other_width = 556;

// Converts UTF-8 to Latin-1, whose letters WinAnsi contains.
std::string latin1(const std::string& utf8) {
  std::string out;
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const auto c = static_cast<unsigned char>(utf8[i]);
    if ((c & 0xc0) == 0x80) continue;  // a continuation byte of a character
    const bool two_bytes = (c & 0xfe) == 0xc2 && i + 1 < utf8.size();
    const unsigned letter =
        two_bytes ? (c & 0x03u) << 6 | (static_cast<unsigned char>(utf8[i + 1]) & 0x3fu) : c;
    const bool known = c < 0x80 ? c >= 0x20 : two_bytes && letter >= 0xa0;
    out += known ? static_cast<char>(letter) : '?';
  }
  return out;
}

double text_width(const std::string& letters) {
  int sum = 0;
  for (char letter : letters) {
    const int index = static_cast<unsigned char>(letter) - ' ';
    sum += index < static_cast<int>(letter_widths.size()) ? letter_widths[index] : other_width;
  }
  return sum * font_size / 1000;
}

std::string string_pdf(const std::string& letters) {
  std::string out = "(";
  for (char letter : letters) {
    if (letter == '(' || letter == ')' || letter == '\\') out += '\\';
    out += letter;
  }
  return out + ")";
}

// A PDF command: operands and an operator.
std::string command(std::initializer_list<double> numbers, const char* name) {
  std::string out;
  for (double number : numbers) out += plain_number(number, 2) + " ";
  return out + name + "\n";
}

std::string ink_pdf(std::uint32_t colour, const char* name) {
  std::string out;
  // Three digits are enough for readers to restore the same byte.
  for (int shift : {16, 8, 0}) out += plain_number((colour >> shift & 0xffu) / 255.0, 3) + " ";
  return out + name + "\n";
}

std::string stroke_pdf(const DrawnStroke& stroke, std::uint32_t ink) {
  std::string out = ink_pdf(stroke.faint ? faint_ink : ink, "RG") + command({stroke.width}, "w");
  for (std::size_t i = 0; i < stroke.points.size(); ++i)
    out += command({stroke.points[i].x(), stroke.points[i].y()}, i == 0 ? "m" : "l");
  return out + "S\n";
}

// A dot is a line of length zero with round ends.
std::string dot_pdf(const DrawnDot& dot, std::uint32_t ink) {
  return "q 1 J\n" + stroke_pdf({{dot.centre, dot.centre}, 2 * dot.radius}, ink) + "Q\n";
}

// content_of() turns the page upside down, so text has to be turned back.
std::string text_pdf(const DrawnText& text) {
  const std::string letters = latin1(text.text);
  const double before = text.anchor == Anchor::start ? 0.0
                        : text.anchor == Anchor::end ? text_width(letters)
                                                     : text_width(letters) / 2;
  const double x = text.at.x(), y = text.at.y();
  return ink_pdf(black, "rg") + "BT " + (text.bold ? "/F2 " : "/F1 ") + command({font_size}, "Tf") +
         (text.upward ? command({0, -1, -1, 0, x, y + before}, "Tm")
                      : command({1, 0, 0, -1, x - before, y}, "Tm")) +
         string_pdf(letters) + " Tj ET\n";
}

std::string content_of(const Drawing& drawing) {
  std::string out = command({1, 0, 0, -1, 0, drawing.height}, "cm") + "1 j\n";
  for (const DrawnPart& part : drawing.parts) {
    const std::uint32_t ink = part.series ? series_colours[*part.series % series_colours.size()] : black;
    for (const DrawnStroke& stroke : part.strokes) out += stroke_pdf(stroke, ink);
    for (const DrawnDot& dot : part.dots) out += dot_pdf(dot, ink);
    for (const DrawnText& text : part.texts) out += text_pdf(text);
  }
  return out;
}

std::string font_pdf(const char* name) {
  return std::string("<< /Type /Font /Subtype /Type1 /BaseFont /") + name + " /Encoding /WinAnsiEncoding >>";
}

}  // namespace

std::string pdf_chart(const Chart& chart) {
  const Drawing drawing = chart_drawing(chart);
  const std::string content = content_of(drawing);
  // PDF numbers its objects from 1.
  const std::vector<std::string> objects{
      "<< /Type /Catalog /Pages 2 0 R >>",
      "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
      "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 " + plain_number(drawing.width, 0) + " " +
          plain_number(drawing.height, 0) +
          "] /Contents 4 0 R /Resources << /Font << /F1 5 0 R /F2 6 0 R >> >> >>",
      "<< /Length " + std::to_string(content.size()) + " >>\nstream\n" + content + "endstream",
      font_pdf("Helvetica"),
      font_pdf("Helvetica-Bold"),
      "<< /Title " + string_pdf(latin1(drawing.title)) + " >>"};
  std::string out = "%PDF-1.4\n%\xe2\xe3\xcf\xd3\n", offsets = "0000000000 65535 f \n";
  for (std::size_t i = 0; i < objects.size(); ++i) {
    char offset[24];
    std::snprintf(offset, sizeof offset, "%010zu 00000 n \n", out.size());
    offsets += offset;
    out += std::to_string(i + 1) + " 0 obj\n" + objects[i] + "\nendobj\n";
  }
  const std::string count = std::to_string(objects.size() + 1), table = std::to_string(out.size());
  return out + "xref\n0 " + count + "\n" + offsets + "trailer\n<< /Size " + count +
         " /Root 1 0 R /Info 7 0 R >>\nstartxref\n" + table + "\n%%EOF\n";
}

}  // namespace foramen
