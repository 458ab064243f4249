#include "repair_options.hpp"

#include "described_option.hpp"

namespace foramen::app {

void add_unit_option(CLI::App& command, InputUnit& unit) {
  std::map<std::string, InputUnit> units;
  for (const LengthUnit length :
       {LengthUnit::millimetre, LengthUnit::centimetre, LengthUnit::metre, LengthUnit::micrometre})
    units.emplace(name(length), input_unit(length));
  add_choice(command, "--units", unit, units,
             "unit of the input files; mm, if given, also takes sizes that no vertebra has")
      ->default_str("mm");
}

std::vector<CLI::Option*> add_repair_options(CLI::App& command, RepairOptions& options) {
  return {add_described(command, "--handle-limit", options, "handle_limit"),
          add_described(command, "--hole-limit", options, "hole_limit")};
}

}  // namespace foramen::app
