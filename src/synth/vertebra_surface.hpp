#pragma once
/// \file
/// The template of synthetic cohorts: a lumbar vertebra as an implicit surface.

#include "foramen/core/geometry.hpp"
#include "synth/isosurface.hpp"

namespace foramen {

/// The implicit function of a lumbar vertebra of natural size in mm, exactly symmetric left to right: x
/// points to the left, y backwards, z upwards, and the origin is the centre of the body.
///
/// Body of 48 x 34 x 27 mm with concave endplates, a waist and a hollow posterior wall, two pedicles,
/// laminae, a hatchet-like spinous process, two transverse and four articular processes, the canal cut out of
/// the arch. Parts are joined by the cubic polynomial smooth minimum \f$ \min(a,b) - k h^3/6,\ h = \max(0, 1
/// - |a-b|/k) \f$, so that the function is continuously differentiable near the surface, which is one closed
/// surface of genus 1.
ImplicitValue vertebra_surface(const Vec3& point);

/// A box that contains the whole surface with a margin of some millimetres.
BoundingBox vertebra_bounds();

}  // namespace foramen
