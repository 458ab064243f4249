#pragma once
/// \file
/// Where the results of finished stages are stored.

#include <optional>
#include <string>
#include <string_view>

namespace foramen {

/// Interface of a key-value store of results. All members may be called from many threads at once.
class StageStore {
 public:
  virtual ~StageStore() = default;
  /// A cryptographic hash of the bytes as text of fixed length.
  virtual std::string digest(std::string_view bytes) const = 0;
  /// The bytes that were stored under this key; nullopt if there are none or the entry is damaged.
  virtual std::optional<std::string> load(const std::string& key) = 0;
  /// Stores the bytes under this key. Does not throw if the store cannot be written, because a missing entry
  /// only costs the time to compute it again.
  virtual void keep(const std::string& key, std::string_view bytes) = 0;
};

}  // namespace foramen
