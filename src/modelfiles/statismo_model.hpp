#pragma once

#include <string>
#include <vector>

#include "foramen/io/statismo_file.hpp"
#include "foramen/model/shape_model.hpp"

namespace foramen {

/// Scores of aligned shapes, modes x shapes, in standard deviations.
Eigen::MatrixXd scores_of(const ShapeModel& model, const std::vector<Eigen::VectorXd>& shapes);

/// A model of these aligned shapes as a file holds it; names of the shapes are left to the caller. The layout
/// knows modes that are orthonormal without weights only: it gets the same distribution of shapes in such
/// modes, and the weights beside.
StatismoModel statismo_model(const ShapeModel& model, const std::vector<Eigen::VectorXd>& aligned,
                             const std::string& command);

}  // namespace foramen
