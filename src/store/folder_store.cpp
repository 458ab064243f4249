#include "foramen/store/folder_store.hpp"

#include <fstream>
#include <iterator>
#include <utility>

#include "foramen/core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/sha256.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

// The header of an entry: its key and the checksum of the rest.
std::string header(const std::string& key, std::string_view bytes) {
  return "foramen stage\n" + key + "\n" + sha256(bytes) + "\n";
}

}  // namespace

FolderStore::FolderStore(fs::path folder, std::string program, Use use)
    : folder_(std::move(folder)), program_(std::move(program)), use_(use) {
  if (use_ == Use::alone) remove_leftovers(folder_);
}

std::string FolderStore::digest(std::string_view bytes) const { return sha256(bytes); }

fs::path FolderStore::file_of(const std::string& key) const {
  return folder_ / sha256(program_ + "\n" + key);
}

std::optional<std::string> FolderStore::load(const std::string& key) {
  const fs::path file = file_of(key);
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const std::size_t header_size = header(key, {}).size();
  if (bytes.size() >= header_size) {
    std::string payload = bytes.substr(header_size);
    if (bytes.starts_with(header(key, payload))) {
      ++taken_up_;
      return payload;
    }
  }
  note(file.string() + ": the finished stage kept there is damaged and is computed again");
  return std::nullopt;
}

void FolderStore::keep(const std::string& key, std::string_view bytes) {
  if (!keeping_) return;
  std::error_code failed;
  fs::create_directories(folder_, failed);
  try {
    write_file(file_of(key), header(key, bytes).append(bytes));
  } catch (const IoError& e) {
    if (!keeping_.exchange(false)) return;
    note(std::string("finished stages are not kept, so that this build could not be resumed: ") + e.what());
    // The disk may be full, and the model files need the space.
    if (use_ == Use::alone) fs::remove_all(folder_, failed);
  }
}

std::vector<std::string> FolderStore::notes() const {
  const std::lock_guard lock(mutex_);
  return notes_;
}

void FolderStore::note(std::string text) {
  const std::lock_guard lock(mutex_);
  notes_.push_back(std::move(text));
}

void FolderStore::remove() {
  keeping_ = false;
  std::error_code failed;
  fs::remove_all(folder_, failed);
  if (failed) note(folder_.string() + ": cannot be removed (" + failed.message() + ")");
}

}  // namespace foramen
