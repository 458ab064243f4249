// What the program's commands include, parsed once a build.
#pragma once
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "library.hpp"
