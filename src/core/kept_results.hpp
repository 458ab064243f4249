#pragma once
/// \file
/// Results of finished stages in the run's store. The key of each is a digest of everything from which it was
/// computed.

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/byte_archive.hpp"
#include "core/option_bytes.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/core/stage_store.hpp"

namespace foramen {

/// The key of a result: the name of its stage and the digest of all its inputs. An input is a value with a
/// transfer(), a struct of described options, or the key of another result, which stands for that result. If
/// the run has no store, the key is empty and no digest is computed.
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
/// The first field of a stored entry: whether it holds a result or an error. Only errors that the same input
/// causes every time are stored.
enum class KeptKind { result, invalid_input, topology_error, convergence_error };

/// The kind under which an error is stored; nullopt for an error that need not occur again with the same
/// input (cancellation, memory, files) and for a defect of foramen.
std::optional<KeptKind> kept_kind(const std::exception& error);
[[noreturn]] void throw_kept(KeptKind kind, const Message& message);
}  // namespace detail

/// Returns the result that the run's store holds under this key, or else calls `work`, stores its result and
/// returns it. An error that follows from the input is stored too and thrown again on the next call. Without
/// a store this is a plain call of `work`.
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
