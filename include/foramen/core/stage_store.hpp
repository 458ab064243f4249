#pragma once
/// \file
/// Results of finished work, kept so that a run that was cut off need not do it again.

#include <optional>
#include <string>
#include <string_view>

#include "foramen/core/byte_archive.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen {

/// Where they are kept. Safe to use from many threads.
class StageStore {
 public:
  virtual ~StageStore() = default;
  /// What was kept under this key, byte for byte; nothing if there is nothing, or it is not what was kept.
  virtual std::optional<std::string> load(const std::string& key) = 0;
  /// A store that cannot keep loses nothing but time: it does not throw.
  virtual void keep(const std::string& key, std::string_view bytes) = 0;
};

/// The result of `work`: as it was kept under this name in the run's store, or else computed, and kept if it
/// did not throw. The name must say all that the result depends on beyond the context's scope.
template <class Result, class Work>
Result kept(const RunContext& ctx, const std::string& name, const Work& work) {
  StageStore* store = ctx.store();
  if (store == nullptr) return work();
  const std::string key = ctx.store_scope() + "/" + name;
  if (const auto bytes = store->load(key)) return from_bytes<Result>(*bytes);
  Result result = work();
  store->keep(key, to_bytes(result));
  return result;
}

}  // namespace foramen
