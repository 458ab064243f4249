#include "pages/page_marks.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "findings/model_report.hpp"

namespace foramen {
namespace {

constexpr int scatter_digits = 2;

// Blue, green, purple and black of Okabe and Ito's colours, which all people can tell apart. The others are
// close to the colours of the surface.
constexpr std::array palette{Colour{0, 114, 178}, Colour{0, 158, 115}, Colour{204, 121, 167},
                             Colour{30, 30, 30}};

double distance_of(const MarkScatter& a, const MarkScatter& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& p : a.centre)
    for (const Vec3& q : b.centre) least = std::min(least, (p - q).norm());
  return least;
}

// The colour whose closest mark so far is farthest; the first of those that no mark has yet.
Colour farthest_colour(const MarkScatter& mark, const std::vector<PageMark>& coloured) {
  Colour best{};
  double farthest = -1;
  for (const Colour& colour : palette) {
    double closest = std::numeric_limits<double>::infinity();
    for (const PageMark& other : coloured)
      if (other.colour == colour) closest = std::min(closest, distance_of(mark, other.scatter));
    if (closest > farthest) {
      farthest = closest;
      best = colour;
    }
  }
  return best;
}

}  // namespace

std::vector<PageMark> page_marks(const ModelRecord& record) {
  std::vector<PageMark> marks;
  if (!record.evaluation.marks) return marks;
  const ShapeModel& model = record.loaded.model;
  const Mesh mean = build_mesh({unflattened(model.mean()), model.triangles()});
  for (MarkScatter& scatter : mark_scatter(mean, record.evaluation.marks->placed)) {
    const Colour colour = farthest_colour(scatter, marks);
    marks.push_back({std::move(scatter), colour});
  }
  return marks;
}

ReportTable scatter_table(const std::vector<PageMark>& marks) {
  ReportTable table{"Scatter of the marks on the mean",
                    "root mean square distance of the shapes' marks to their centre or mean curve",
                    {"mark", "shapes", "scatter, mm"},
                    {}};
  for (const PageMark& mark : marks)
    table.rows.push_back({mark.scatter.mark, std::to_string(mark.scatter.placed.size()),
                          fixed(mark.scatter.rms, scatter_digits)});
  return table;
}

}  // namespace foramen
