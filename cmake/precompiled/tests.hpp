// Headers that most tests include, parsed once per build.
#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "library.hpp"
