#pragma once
/// \file
/// Files that appear whole or not at all.

#include <filesystem>
#include <functional>
#include <string_view>

namespace foramen {

/// Writes beside `path` (same folder, hidden temporary name), flushes to disk, then renames over it. On any
/// error the temporary is removed, `path` is untouched and IoError is thrown.
void write_file(const std::filesystem::path& path, std::string_view contents);

/// The same for a library that insists on writing a file by name: `write` is given the temporary's path.
void write_file_with(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path& temporary)>& write);

/// Removes what these left in a folder when their process was killed. \pre nothing is being written there
void remove_leftovers(const std::filesystem::path& folder);

}  // namespace foramen
