#pragma once
/// \file
/// Writes files atomically: a reader finds the complete new file or the old state, never a part. Makes the
/// folders for them.

#include <filesystem>
#include <functional>
#include <string_view>

namespace foramen {

/// Makes the folder to write to, with those above it, if it does not exist. Throws IoError if it cannot be
/// made.
void make_folder(const std::filesystem::path& folder);

/// Writes a hidden temporary file in the folder of `path`, flushes it to disk and renames it to `path`. On
/// any error the temporary file is removed, `path` stays as it was and IoError is thrown.
void write_file(const std::filesystem::path& path, std::string_view contents);

/// The same for a library that writes only to a file name: `write` gets the path of the temporary file.
void write_file_with(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path& temporary)>& write);

/// Removes the temporary files that a killed process left in a folder. \pre no process is writing in the
/// folder
void remove_leftovers(const std::filesystem::path& folder);

}  // namespace foramen
