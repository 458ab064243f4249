#pragma once

#include <string>
#include <vector>

#include "modelfiles/model_record.hpp"

namespace foramen {

/// One thing worth knowing about a model.
struct Statement {
  std::string heading, text;
};

/// What the model is, how its shapes differ, how exact it is and how far it can be trusted, for readers who
/// know vertebrae and no statistics.
std::vector<Statement> in_plain_words(const ModelRecord& record);

}  // namespace foramen
