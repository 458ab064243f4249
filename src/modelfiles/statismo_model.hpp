#pragma once

#include <string>
#include <vector>

#include "foramen/io/statismo_file.hpp"
#include "foramen/model/shape_model.hpp"

namespace foramen {

/// The scores of aligned shapes, modes x shapes, in standard deviations.
Eigen::MatrixXd scores_of(const ShapeModel& model, const std::vector<Eigen::VectorXd>& shapes);

/// The contents of the file of a model and its aligned shapes. The caller sets the names of the shapes. The
/// layout of the file allows only modes that are orthonormal without weights. A model with landmark weights
/// is therefore converted to such modes with the same distribution of shapes, and the weights are stored
/// beside them.
StatismoModel statismo_model(const ShapeModel& model, const std::vector<Eigen::VectorXd>& aligned,
                             const std::string& command);

}  // namespace foramen
