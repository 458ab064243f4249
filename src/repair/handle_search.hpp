#pragma once
// The next handle to remove, with its loops.

#include "foramen/repair/find_handles.hpp"

namespace foramen::repair_detail {

struct FoundHandle {
  Handle handle;
  EdgeLoop loop;      ///< of handle.kind, simple
  EdgeLoop crossing;  ///< the shortest that crosses it
};

/// The handle whose shorter loop is shortest. \pre closed, connected, outward, genus at least 1
FoundHandle shortest_handle(const Mesh& mesh, const RunContext& ctx);

/// All handles of a surface but the last.
struct ExtraHandles {
  std::vector<Handle> handles;  ///< each the shortest when those before are gone
  Mesh rest;                    ///< of genus 1, see cut_and_closed
};
ExtraHandles extra_handles(const Mesh& mesh, const RunContext& ctx);

}  // namespace foramen::repair_detail
