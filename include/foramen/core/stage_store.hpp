#pragma once
/// \file
/// Results of finished work, kept under the name of what they were made from.

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "foramen/core/byte_archive.hpp"
#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen {

/// Where results are kept. Safe to use from many threads.
class StageStore {
 public:
  virtual ~StageStore() = default;
  /// A name of fixed length for any bytes; other bytes have another name.
  virtual std::string digest(std::string_view bytes) const = 0;
  /// What was kept under this key, byte for byte; nothing if there is nothing, or it is not what was kept.
  virtual std::optional<std::string> load(const std::string& key) = 0;
  /// A store that cannot keep loses nothing but time: it does not throw.
  virtual void keep(const std::string& key, std::string_view bytes) = 0;
};

/// The name of a result: the stage that makes it, and the digest of all that it is made from. A part is a
/// value with a transfer(), a struct of described options, or the key of another result, which stands for
/// that result. Without a store the key is empty, and nothing is computed for it.
class StageKey {
 public:
  StageKey() = default;
  template <class... Parts>
  StageKey(const RunContext& ctx, std::string_view stage, const Parts&... parts) {
    if (ctx.store() == nullptr) return;
    ByteWriter writer;
    (add(writer, parts), ...);
    text_ = std::string(stage) + " " + ctx.store()->digest(writer.take());
  }
  const std::string& text() const { return text_; }
  friend bool operator==(const StageKey&, const StageKey&) = default;

 private:
  template <class Part>
  static void add(ByteWriter& writer, const Part& part) {
    if constexpr (std::is_same_v<Part, StageKey>)
      writer(part.text_);
    else if constexpr (DescribedOptions<const Part>)
      writer(option_bytes(part));
    else
      writer(part);
  }
  std::string text_;
};

template <class Archive>
void transfer(Archive& archive, MaybeConst<StageKey> auto& key) {
  static_assert(!Archive::reads, "a key is made, never read");
  archive(key.text());
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<Remedy> auto& remedy) {
  archive(remedy.kind, remedy.value);
}
template <class Archive>
void transfer(Archive& archive, MaybeConst<Message> auto& message) {
  archive(message.text, message.remedies);
}

namespace detail {
/// How a kept entry begins: with a result, or with the kind of error that the same input gives every time.
enum class KeptKind { result, invalid_input, topology_error, convergence_error };

/// The kind of an error that follows from the input; nothing for one that may not come again (cancellation,
/// memory, files) or is a defect of ours.
std::optional<KeptKind> kept_kind(const std::exception& error);
[[noreturn]] void throw_kept(KeptKind kind, const Message& message);
}  // namespace detail

/// The result of `work`: as it was kept under this key in the run's store, or else computed and kept. An
/// error that follows from the input is kept and thrown again like a result.
template <class Result, class Work>
Result kept(const RunContext& ctx, const StageKey& key, const Work& work) {
  StageStore* store = ctx.store();
  if (store == nullptr) return work();
  if (const auto bytes = store->load(key.text())) {
    ByteReader reader(*bytes);
    auto kind = detail::KeptKind::result;
    reader(kind);
    if (kind != detail::KeptKind::result) {
      Message message;
      reader(message);
      detail::throw_kept(kind, message);
    }
    Result result;
    reader(result);
    FORAMEN_ASSERT(reader.at_end());
    return result;
  }
  ByteWriter writer;
  try {
    Result result = work();
    writer(detail::KeptKind::result, result);
    store->keep(key.text(), writer.take());
    return result;
  } catch (const Error& error) {
    if (const auto kind = detail::kept_kind(error)) {
      writer(*kind, message_of(error));
      store->keep(key.text(), writer.take());
    }
    throw;
  }
}

}  // namespace foramen
