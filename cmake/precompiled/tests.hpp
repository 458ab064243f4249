// What most tests include, parsed once a build.
#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "library.hpp"
