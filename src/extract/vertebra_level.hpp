#pragma once
/// \file
/// The level of a vertebra in a name that a person or a program gave.

#include <optional>
#include <string>
#include <string_view>

namespace foramen {

/// The level that a name stands for, as C1, T12, L5, S1, sacrum or coccyx: "L1", "vertebrae_L1", "L1
/// vertebra", "Lumbar vertebra 1", "first lumbar vertebra", "Th4". Nullopt if the name has no level,
/// several, or words that make it another structure ("L1 left pedicle", "L1-L2 disc").
std::optional<std::string> level_of(std::string_view name);

struct LevelInName {
  std::string level, rest;  ///< `rest` is the name without the level and the words about vertebrae
};
/// The level in the name of a file without extension, which may hold other words: "s0001_vertebrae_L1"
/// gives L1 and s0001. Nullopt if there is no level or more than one, none of them right after "vertebra".
std::optional<LevelInName> level_in_file_name(std::string_view stem);

/// The letter of the part of the spine that a file's name tells: T for "sub-02_thoracic". Nullopt if it
/// tells none or several.
std::optional<char> region_in_file_name(std::string_view stem);

/// The place of a level from head to foot: neighbours differ by 2; T13 and L6, which few spines have, stand
/// between their neighbours. Nullopt for a name that is no level.
std::optional<int> rank_of_level(std::string_view level);

}  // namespace foramen
