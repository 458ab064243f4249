#pragma once
/// \file
/// Options as bytes, for the keys of stored results.

#include <string>

#include "core/byte_archive.hpp"
#include "foramen/core/options.hpp"

namespace foramen {

namespace detail {
template <class Field>
void add_option_bytes(ByteWriter& writer, const Field& field);

template <class Options>
void add_options_bytes(ByteWriter& writer, const Options& options) {
  for_each_option(options, [&](const std::string& path, const auto& field, const OptionText&) {
    writer(path);
    add_option_bytes(writer, field);
  });
}

template <class Field>
void add_option_bytes(ByteWriter& writer, const Field& field) {
  if constexpr (is_vector<Field>) {
    writer(std::ssize(field));
    for (const auto& item : field)
      if constexpr (DescribedOptions<const typename Field::value_type>)
        add_options_bytes(writer, item);
      else
        writer(item);
  } else {
    writer(field);
  }
}
}  // namespace detail

/// Names and values of all options as bytes, for keys of stored results. Two structs of one type have the
/// same bytes if and only if all their options are bitwise equal.
template <DescribedOptions Options>
std::string option_bytes(const Options& options) {
  ByteWriter writer;
  detail::add_options_bytes(writer, options);
  return writer.take();
}

}  // namespace foramen
