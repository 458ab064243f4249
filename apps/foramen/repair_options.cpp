#include "repair_options.hpp"

namespace foramen::app {

void add_unit_option(CLI::App& command, LengthUnit& unit) {
  add_choice<LengthUnit>(command, "--units", unit,
                         {{"mm", LengthUnit::millimetre},
                          {"cm", LengthUnit::centimetre},
                          {"m", LengthUnit::metre},
                          {"um", LengthUnit::micrometre}},
                         "unit of the input files");
}

std::vector<CLI::Option*> add_repair_options(CLI::App& command, RepairOptions& options) {
  CLI::Option* handles =
      command
          .add_option("--handle-limit", options.handles.noise_mm,
                      "an extra handle is noise if both its loops are at most this long [mm]")
          ->check(CLI::PositiveNumber)
          ->capture_default_str();
  CLI::Option* holes = command
                           .add_option("--hole-limit", options.hole_perimeter_mm,
                                       "a hole is filled if its border is at most this long [mm]")
                           ->check(CLI::PositiveNumber)
                           ->capture_default_str();
  return {handles, holes};
}

}  // namespace foramen::app
