// Headers that the program's commands include, parsed once per build.
#pragma once
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "library.hpp"
