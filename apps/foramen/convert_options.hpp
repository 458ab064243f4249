#pragma once
/// \file
/// The options of a conversion, and the output about it.

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "command.hpp"
#include "exchange/convert.hpp"

namespace foramen::app {

/// Adds --to, --units, --triangles, --scale.
void add_convert_options(CLI::App& command, ConvertRequest& request);

/// The command in the form in which models record it.
std::string recorded_command(const ConvertRequest& request);

/// A JSON object with output, files, shapes, landmarks and notes.
nlohmann::ordered_json convert_json(const ConvertRequest& request, const ConvertSummary& summary);

}  // namespace foramen::app
