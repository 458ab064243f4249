#include "foramen/synth/synth_cohort.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <numeric>
#include <span>
#include <sstream>
#include <string>

#include "core/parallel.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/core/rng.hpp"
#include "synth/isosurface.hpp"
#include "synth/random_flow.hpp"
#include "synth/rough_deformation.hpp"
#include "synth/vertebra_surface.hpp"

namespace foramen {
namespace {

constexpr int truth_vertices = 10000;
constexpr double lattice_spacing_mm = 2.0;
constexpr double farthest_shift_mm = 200;
constexpr int fewest_vertices =
    1500;  // with fewer vertices the triangles are longer than the processes are thick

// Indices of the random streams: one for the cohort, and one for each random choice of an item.
enum class CohortStream : std::uint64_t { shared_fields = 0, first_item = 1 };
enum class ItemStream : std::uint64_t { lattice, deformation, order, pose, roughness, density, noise };

Rng item_stream(const SynthOptions& options, int item, ItemStream purpose) {
  const Rng root(options.seed);
  return root.fork(static_cast<std::uint64_t>(CohortStream::first_item) + static_cast<std::uint64_t>(item))
      .fork(static_cast<std::uint64_t>(purpose));
}

void require(bool fine, const std::string& what, double found) {
  if (fine) return;
  std::ostringstream message;
  message << "synth: " << what << ", found " << found;
  throw InvalidInput(message.str());
}

void check(const SynthOptions& options) {
  require(options.shapes >= 1, "shapes must be at least 1", options.shapes);
  require(options.modes >= 0, "modes must be >= 0", options.modes);
  require(options.amplitude_mm >= 0 && std::isfinite(options.amplitude_mm), "amplitude_mm must be >= 0",
          options.amplitude_mm);
  require(options.correlation_mm > 0 && std::isfinite(options.correlation_mm), "correlation_mm must be > 0",
          options.correlation_mm);
  require(options.vertices >= fewest_vertices, "vertices must be at least " + std::to_string(fewest_vertices),
          options.vertices);
}

Eigen::Quaterniond random_rotation(Rng& rng) {
  // A normally distributed 4-vector has no preferred direction, so the rotation is uniformly distributed.
  double q[4];
  for (double& component : q) component = rng.normal();
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized();
}

RigidTransform random_motion(Rng& rng, double farthest_mm) {
  RigidTransform motion = RigidTransform::Identity();
  motion.linear() = random_rotation(rng).toRotationMatrix();
  for (int k = 0; k < 3; ++k) motion.translation()[k] = rng.uniform(-farthest_mm, farthest_mm);
  return motion;
}

TriangleSoup triangulated_template(const RigidTransform& lattice, int vertices) {
  IsosurfaceOptions options;
  options.bounds = vertebra_bounds();
  options.spacing_mm = lattice_spacing_mm;
  options.lattice = lattice;
  options.vertices = vertices;
  return isosurface(vertebra_surface, options);
}

// The template of all truth meshes, the same for all cohorts.
const TriangleSoup& truth_template() {
  static const TriangleSoup soup = triangulated_template(RigidTransform::Identity(), truth_vertices);
  return soup;
}

// Standard deviations of the true modes. The variances are proportional to 1 / k and sum to amplitude^2.
std::vector<double> mode_deviations(const SynthOptions& options) {
  double sum = 0;
  for (int k = 1; k <= options.modes; ++k) sum += 1.0 / k;
  std::vector<double> deviations;
  for (int k = 1; k <= options.modes; ++k)
    deviations.push_back(options.amplitude_mm * std::sqrt(1.0 / k / sum));
  return deviations;
}

VelocityField smooth_field(const SynthOptions& options, std::span<const VelocityField> shared, Rng& rng) {
  if (options.modes == 0) {
    const auto own = random_velocity_fields(1, {.correlation_mm = options.correlation_mm}, rng);
    return weighted_sum(own, std::vector<double>{options.amplitude_mm});
  }
  std::vector<double> scores = mode_deviations(options);
  for (double& b : scores) b *= rng.normal();
  return weighted_sum(shared, scores);
}

// Number of Runge-Kutta steps, sufficient for displacements of four standard deviations.
int flow_steps(const SynthOptions& options) {
  const double per_correlation = 32 * options.amplitude_mm / options.correlation_mm;
  return std::clamp(static_cast<int>(std::ceil(per_correlation)), 4, 1000);
}

std::vector<int> random_order(std::size_t count, Rng& rng) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[rng.below(static_cast<int>(i))]);
  return order;
}

// Puts vertices and triangles in random order and lets each triangle begin at a random corner.
TriangleSoup shuffled(const TriangleSoup& soup, Rng& rng) {
  const std::vector<int> vertex = random_order(soup.points.size(), rng);
  const std::vector<int> face = random_order(soup.triangles.size(), rng);
  TriangleSoup out;
  out.points.resize(soup.points.size());
  out.triangles.resize(soup.triangles.size());
  for (std::size_t v = 0; v < vertex.size(); ++v) out.points[vertex[v]] = soup.points[v];
  for (std::size_t f = 0; f < face.size(); ++f) {
    const std::size_t first = rng.below(3);
    for (std::size_t k = 0; k < 3; ++k)
      out.triangles[face[f]][k] = vertex[soup.triangles[f][(k + first) % 3]];
  }
  return out;
}

using Carry = std::function<std::vector<Vec3>(std::span<const Vec3>)>;

// The deformation of an item's template before it is posed.
Carry deformation_of(const SynthOptions& options, int item, std::span<const VelocityField> shared) {
  Carry smooth = [](std::span<const Vec3> points) { return std::vector<Vec3>(points.begin(), points.end()); };
  if (options.amplitude_mm > 0) {
    Rng rng = item_stream(options, item, ItemStream::deformation);
    smooth = [field = smooth_field(options, shared, rng), steps = flow_steps(options)](
                 std::span<const Vec3> points) { return carried_by_flow(points, field, steps); };
  }
  if (options.deformation == SynthDeformation::smooth) return smooth;
  Rng rng = item_stream(options, item, ItemStream::roughness);
  return [smooth, rough = synth::RoughDeformation(rng)](std::span<const Vec3> points) {
    return smooth(rough.carried(points));
  };
}

int vertices_of(const SynthOptions& options, int item) {
  if (options.deformation == SynthDeformation::smooth) return options.vertices;
  Rng rng = item_stream(options, item, ItemStream::density);
  return std::max(fewest_vertices, synth::rough_vertex_count(options.vertices, rng));
}

SynthShape make_shape(const SynthOptions& options, int item, const TriangleSoup& truth,
                      std::span<const VelocityField> shared) {
  Rng lattice_rng = item_stream(options, item, ItemStream::lattice);
  Rng order_rng = item_stream(options, item, ItemStream::order);
  Rng pose_rng = item_stream(options, item, ItemStream::pose);

  const Carry deformation = deformation_of(options, item, shared);
  const RigidTransform lattice = random_motion(lattice_rng, lattice_spacing_mm);
  SynthShape shape{triangulated_template(lattice, vertices_of(options, item)), truth};
  for (TriangleSoup* soup : {&shape.surface, &shape.truth}) soup->points = deformation(soup->points);
  if (options.deformation == SynthDeformation::rough) {
    Rng noise_rng = item_stream(options, item, ItemStream::noise);
    synth::add_segmentation_noise(shape.surface, noise_rng);
  }
  const RigidTransform pose = random_motion(pose_rng, farthest_shift_mm);
  for (TriangleSoup* soup : {&shape.surface, &shape.truth}) soup->points = transformed(soup->points, pose);
  shape.surface = shuffled(shape.surface, order_rng);
  return shape;
}

}  // namespace

std::vector<SynthShape> synth_cohort(const SynthOptions& options, const RunContext& ctx) {
  check(options);
  const TriangleSoup& truth = truth_template();
  Rng shared_rng = Rng(options.seed).fork(static_cast<std::uint64_t>(CohortStream::shared_fields));
  const auto shared =
      random_velocity_fields(options.modes, {.correlation_mm = options.correlation_mm}, shared_rng);

  std::vector<SynthShape> shapes(options.shapes);
  std::atomic<int> done{0};
  parallel_for(options.shapes, ctx, [&](int item) {
    shapes[item] = make_shape(options, item, truth, shared);
    ctx.step("synth", static_cast<double>(++done) / options.shapes);
  });
  return shapes;
}

}  // namespace foramen
