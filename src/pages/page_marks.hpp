#pragma once
/// \file
/// The marks of a model's evaluation, as its page and its pictures show them.

#include <vector>

#include "evaluate/mark_scatter.hpp"
#include "modelfiles/model_record.hpp"
#include "render/render_scene.hpp"
#include "report/report_page.hpp"

namespace foramen {

/// The marks of one name with their scatter on the model's mean, and the colour in which they are drawn.
struct PageMark {
  MarkScatter scatter;
  Colour colour{};
};

/// All marks of the evaluation; none if nothing was marked or no places are known. Marks share a few colours
/// that can be told apart with any colour vision, and those of one colour lie far from each other.
std::vector<PageMark> page_marks(const ModelRecord& record);

/// Number of shapes and scatter of each mark; without rows if there is none.
ReportTable scatter_table(const std::vector<PageMark>& marks);

}  // namespace foramen
