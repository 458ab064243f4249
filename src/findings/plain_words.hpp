#pragma once

#include <string>
#include <vector>

#include "modelfiles/model_record.hpp"

namespace foramen {

/// One statement about a model.
struct Statement {
  std::string heading, text;
};

/// Statements about what the model is, how its shapes differ, how accurate it is and how reliable it is, for
/// readers who know vertebrae but no statistics.
std::vector<Statement> in_plain_words(const ModelRecord& record);

}  // namespace foramen
