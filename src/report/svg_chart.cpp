#include "report/svg_chart.hpp"

#include <cstdio>

#include "report/chart_drawing.hpp"
#include "report/html_text.hpp"
#include "report/plain_number.hpp"

namespace foramen {
namespace {

std::string coordinate(double value) { return plain_number(value, 2); }

// A grey that is visible on light and on dark backgrounds.
constexpr const char* faint_ink = "#8884";

std::string ink_of(const DrawnPart& part) {
  if (!part.series) return "currentColor";
  char text[8];
  std::snprintf(text, sizeof text, "#%06X", series_colours[*part.series % series_colours.size()]);
  return text;
}

std::string stroke_svg(const DrawnStroke& stroke, const std::string& ink) {
  std::string points;
  for (const Vec2& p : stroke.points) points += coordinate(p.x()) + "," + coordinate(p.y()) + " ";
  return "<polyline fill=\"none\" stroke-width=\"" + plain_number(stroke.width, 1) + "\" stroke=\"" +
         (stroke.faint ? faint_ink : ink) + "\" points=\"" + points + "\"/>\n";
}

std::string text_svg(const DrawnText& text) {
  static constexpr std::array<const char*, 3> anchors{"start", "middle", "end"};
  const std::string x = coordinate(text.at.x()), y = coordinate(text.at.y());
  return "<text x=\"" + x + "\" y=\"" + y + "\" text-anchor=\"" +
         anchors[static_cast<std::size_t>(text.anchor)] + "\"" + (text.bold ? " font-weight=\"bold\"" : "") +
         (text.upward ? " transform=\"rotate(-90 " + x + " " + y + ")\"" : "") + ">" +
         html_escaped(text.text) + "</text>\n";
}

std::string part_svg(const DrawnPart& part) {
  const std::string ink = ink_of(part);
  std::string out = part.series ? "<g class=\"series-" + std::to_string(*part.series) + "\">\n" : "<g>\n";
  for (const DrawnStroke& stroke : part.strokes) out += stroke_svg(stroke, ink);
  for (const DrawnDot& dot : part.dots)
    out += "<circle cx=\"" + coordinate(dot.centre.x()) + "\" cy=\"" + coordinate(dot.centre.y()) +
           "\" r=\"" + plain_number(dot.radius, 1) + "\" fill=\"" + ink + "\"/>\n";
  for (const DrawnText& text : part.texts) out += text_svg(text);
  return out + "</g>\n";
}

std::string drawing_svg(const Drawing& drawing, const std::string& attributes, const std::string& behind) {
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " +
                    plain_number(drawing.width, 0) + " " + plain_number(drawing.height, 0) + "\" " +
                    attributes + "role=\"img\" aria-label=\"" + html_escaped(drawing.title) +
                    "\" font-family=\"sans-serif\" font-size=\"12\" fill=\"currentColor\">\n" + behind;
  for (const DrawnPart& part : drawing.parts) out += part_svg(part);
  return out + "</svg>\n";
}

}  // namespace

std::string svg_chart(const Chart& chart) { return drawing_svg(chart_drawing(chart), "", ""); }

std::string svg_chart_file(const Chart& chart) {
  const Drawing drawing = chart_drawing(chart);
  const std::string size =
      "width=\"" + plain_number(drawing.width, 0) + "\" height=\"" + plain_number(drawing.height, 0) + "\" ";
  return drawing_svg(drawing, size, "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n");
}

}  // namespace foramen
