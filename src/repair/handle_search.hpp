#pragma once
// The search for the next handle to remove.

#include "foramen/repair/handles.hpp"

namespace foramen::repair_detail {

struct FoundHandle {
  Handle handle;
  EdgeLoop loop;      ///< the first loop of the handle, of kind handle.kind; it visits no vertex twice
  EdgeLoop crossing;  ///< the second loop of the handle, which crosses the first
};

/// The handle with the shortest loop. \pre closed, connected, outward, genus at least 1
FoundHandle shortest_handle(const Mesh& mesh, const RunContext& ctx);

/// All handles of a surface except the last one.
struct ExtraHandles {
  std::vector<Handle> handles;  ///< each is the shortest one of the surface without the handles before it
  Mesh rest;                    ///< the surface of genus 1 that is left, made by cut_and_closed()
};
ExtraHandles extra_handles(const Mesh& mesh, const RunContext& ctx);

}  // namespace foramen::repair_detail
