#include "repair_options.hpp"

#include "described_option.hpp"

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
  return {add_described(command, "--handle-limit", options, "handle_limit"),
          add_described(command, "--hole-limit", options, "hole_limit")};
}

}  // namespace foramen::app
