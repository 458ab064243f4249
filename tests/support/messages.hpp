#pragma once
/// \file
/// What refused work says and offers.

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"

namespace foramen::testing {

template <class Work>
Message refusal(const Work& work) {
  try {
    work();
  } catch (const Error& e) {
    return message_of(e);
  }
  ADD_FAILURE() << "not refused";
  return {};
}

/// Matches a message whose text has these words.
inline auto says(const std::string& words) {
  return ::testing::Field("text", &Message::text, ::testing::HasSubstr(words));
}

/// Matches a message with these remedies and no others.
inline auto offers(std::vector<Remedy> remedies) {
  return ::testing::Field("remedies", &Message::remedies, ::testing::ContainerEq(std::move(remedies)));
}

}  // namespace foramen::testing
