#include "synth/vertebra_surface.hpp"

#include <variant>
#include <vector>

#include "synth/jet.hpp"
#include "synth/solids.hpp"

namespace foramen {
namespace {

using synth::Ball;
using synth::Capsule;
using synth::Jet;
using synth::Plate;

struct Part {
  std::variant<Plate, Capsule> solid;
  double blend_mm;  // width over which the part is blended with the earlier ones
  Ball ball;
};

template <class Solid>
Part part(const Solid& solid, double blend_mm) {
  return {solid, blend_mm, solid.ball()};
}

Vec3 mirrored(const Vec3& v) { return {-v.x(), v.y(), v.z()}; }
Jet mirrored(const Jet& j) { return {j.value, mirrored(j.gradient)}; }

// A sequence of parts that are joined one after another.
class Assembly {
 public:
  template <class Solid>
  void add(const Solid& solid, double blend_mm) {
    parts_.push_back(part(solid, blend_mm));
  }
  /// Joins the parts to a solid with the distance `sum` at p.
  Jet joined(Jet sum, const Vec3& p) const {
    for (const Part& part : parts_) {
      // A part farther away than the width of the blend has no effect, so skipping it does not change the
      // result.
      const double reach = sum.value + part.blend_mm + part.ball.radius;
      if (reach < 0 || (p - part.ball.centre).squaredNorm() > reach * reach) continue;
      const Jet d = std::visit([&](const auto& solid) { return solid.distance(p); }, part.solid);
      sum = synth::smooth_min(sum, d, part.blend_mm);
    }
    return sum;
  }

 private:
  std::vector<Part> parts_;
};

// The smooth minimum of several parts depends on their order. Both sides are therefore joined separately, the
// right one as a mirror image, so that the arch is exactly symmetric.
struct Arch {
  Assembly left, middle;

  Jet distance(const Vec3& p) const {
    constexpr double far_mm = 1e3, blend_mm = 5;
    const Jet nothing{far_mm, Vec3::Zero()};
    const Jet sides =
        synth::smooth_min(left.joined(nothing, p), mirrored(left.joined(nothing, mirrored(p))), blend_mm);
    return middle.joined(sides, p);
  }
};

// Sizes and positions of the parts of the left side in mm, as measured on lumbar vertebrae.
Arch make_arch() {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  using synth::frame;
  Arch arch;
  // pedicle, and the pillar between the articular processes (pars)
  arch.left.add(Plate{{15.2, 20.5, 5.2}, frame(y + 0.12 * x, z), {10.5, 7.0, 3.9}, 5.0, 3.5}, 4);
  arch.left.add(Capsule{{16.2, 30.5, 6.0}, {12.0, 35.0, -14.0}, 4.8, 4.6}, 5);
  // laminae: steep plates that meet behind the canal
  arch.left.add(
      Plate{{7.0, 34.6, -6.5}, frame(Vec3(-1, 0.50, 0), Vec3(0, 0.30, -1)), {10.0, 9.8, 3.3}, 5.0, 2.9}, 5);
  // superior articular process: a blade with a facet that faces inwards and backwards; behind it the
  // mammillary process
  arch.left.add(Plate{{17.8, 34.4, 10.6}, frame(y + 0.32 * x, z - 0.12 * y), {8.2, 10.0, 3.3}, 6.8, 3.0}, 5);
  arch.left.add(Capsule{{19.8, 38.5, 4.0}, {20.4, 41.0, 9.5}, 3.6, 3.0}, 4);
  // inferior articular process with a facet that faces outwards and forwards
  arch.left.add(
      Plate{{11.6, 36.8, -18.0}, frame(z + 0.10 * y - 0.14 * x, x + 0.75 * y), {12.0, 5.8, 3.8}, 5.2, 3.3},
      6);
  // transverse process
  arch.left.add(Capsule{{17.5, 29.5, 3.5}, {31.0, 32.3, 4.5}, 5.4, 3.2}, 5);
  arch.left.add(Plate{{31.5, 32.8, 4.5}, frame(Vec3(1, 0.26, 0.06), z), {12.5, 5.2, 2.7}, 4.6, 2.4}, 5);
  // spinous process
  arch.middle.add(Capsule{{0, 36.5, -5.0}, {0, 44, -8.5}, 5.4, 3.8}, 6);
  arch.middle.add(Plate{{0, 50.5, -9.0}, frame(Vec3(0, 1, -0.18), z + 0.1 * y), {15.0, 8.6, 2.9}, 6.5, 2.6},
                  5);
  arch.middle.add(Capsule{{0, 61.5, -6.0}, {0, 58.5, -18.0}, 3.4, 4.4}, 6);
  return arch;
}

// The vertebral body: a drum with a waist and a hollow back between two concave endplates.
Jet body(const Vec3& p) {
  constexpr double half_width = 24, half_depth = 17, half_height = 13.5;
  constexpr double dish_depth = 2.2, waist = 0.14, hollow_depth = 2.8, rim_mm = 7;
  constexpr double squareness = 1.25;  // exponent of squares; 1 gives an ellipse
  constexpr double softening = 1e-4;   // keeps square roots differentiable on the axis
  const Jet x{p.x(), Vec3::UnitX()}, y{p.y(), Vec3::UnitY()}, z{p.z(), Vec3::UnitZ()};

  const Jet backwards = 0.5 + 0.5 * y / synth::sqrt(y * y + 60.0);  // 0 in front, 1 at the back
  const Jet hollow = hollow_depth * synth::exp(-(x * x) / 130.0) * backwards;
  const Jet girth = 1.0 - waist * synth::exp(-(z * z) / 60.0) - 0.0015 * z;
  const Jet u = x / (half_width * girth), v = (y + hollow) / (half_depth * girth);
  const Jet radius =
      synth::pow(synth::pow(u * u + softening, squareness) + synth::pow(v * v + softening, squareness),
                 0.5 / squareness);
  const Jet side = 0.5 * (half_width + half_depth) * (radius - 1.0);

  const Jet dish = dish_depth * synth::exp(-1.6 * radius * radius * radius);
  const Jet tilt = 0.02 * y;  // the front is a little higher than the back
  const Jet plate = synth::sqrt(z * z + softening) - (half_height - dish - tilt);
  return synth::smooth_max(side, plate, rim_mm);
}

// The canal: a prism of rounded triangular section, narrower at the back.
Jet canal(const Vec3& p) {
  constexpr double half_width = 12, half_depth = 8.5, centre_y = 24.6, softening = 1e-4;
  const Jet x{p.x(), Vec3::UnitX()}, y{p.y(), Vec3::UnitY()};
  const Jet v = (y - centre_y) / half_depth;
  const Jet narrowing = 1.0 - 0.22 * v / synth::sqrt(v * v + 1.0);
  const Jet u = x / (half_width * narrowing);
  return half_depth * (synth::sqrt(u * u + v * v + softening) - 1.0);
}

}  // namespace

ImplicitValue vertebra_surface(const Vec3& point) {
  static const Arch arch = make_arch();
  constexpr double canal_edge_mm = 3, body_blend_mm = 3.5;
  const Jet hollowed = synth::smooth_max(arch.distance(point), -canal(point), canal_edge_mm);
  const Jet all = synth::smooth_min(body(point), hollowed, body_blend_mm);
  return {all.value, all.gradient};
}

BoundingBox vertebra_bounds() { return {Vec3(-50, -24, -38), Vec3(50, 74, 30)}; }

}  // namespace foramen
