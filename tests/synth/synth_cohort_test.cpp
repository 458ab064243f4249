#include "foramen/synth/synth_cohort.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "synth/isosurface.hpp"
#include "synth/vertebra_surface.hpp"

namespace foramen {
namespace {

SynthOptions small(int shapes, std::uint64_t seed = 1) {
  SynthOptions o;
  o.shapes = shapes;
  o.seed = seed;
  o.vertices = 2500;
  return o;
}

const std::vector<SynthShape>& default_shapes() {
  static const auto shapes = synth_cohort({.shapes = 3}, RunContext());
  return shapes;
}

// The truth mesh of the undeformed template, in some pose.
const TriangleSoup& still_truth() {
  static const TriangleSoup truth = synth_cohort({.shapes = 1, .amplitude_mm = 0}, RunContext())[0].truth;
  return truth;
}

RigidTransform rigid_fit(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  const auto matrix = [](const std::vector<Vec3>& p) {
    return Eigen::Map<const Eigen::Matrix3Xd>(p[0].data(), 3, static_cast<Eigen::Index>(p.size()));
  };
  RigidTransform motion;
  motion.matrix() = Eigen::umeyama(matrix(from), matrix(to), false);
  return motion;
}

void expect_fine_surface(const TriangleSoup& soup) {
  const Mesh mesh = build_mesh(soup);
  EXPECT_TRUE(mesh.is_closed());
  EXPECT_EQ(mesh.euler_characteristic(), 0);
  EXPECT_GT(signed_volume(mesh), 0);
}

TEST(SynthCohort, EveryShapeIsAClosedOutwardTorus) {
  struct Case {
    std::uint64_t seed;
    int modes;
    double amplitude, correlation;
    int vertices;
  };
  for (const Case& c : {Case{1, 4, 2.1, 40, 2500}, Case{2, 0, 2.1, 40, 2500}, Case{3, 1, 0, 40, 1500},
                        Case{4, 0, 4, 25, 4000}, Case{5, 2, 3, 60, 20000}}) {
    SCOPED_TRACE("seed " + std::to_string(c.seed));
    SynthOptions o{.shapes = 1, .seed = c.seed, .modes = c.modes};
    o.amplitude_mm = c.amplitude;
    o.correlation_mm = c.correlation;
    o.vertices = c.vertices;
    for (const SynthShape& s : synth_cohort(o, RunContext())) {
      expect_fine_surface(s.surface);
      expect_fine_surface(s.truth);
      EXPECT_NEAR(static_cast<double>(s.surface.points.size()), c.vertices, 0.05 * c.vertices);
    }
  }
}

TEST(SynthCohort, TruthMeshesShareTheirTriangles) {
  const auto& shapes = default_shapes();
  for (const SynthShape& s : shapes) {
    EXPECT_EQ(s.truth.triangles, shapes[0].truth.triangles);
    EXPECT_EQ(s.truth.points.size(), shapes[0].truth.points.size());
  }
}

// Surface and truth are triangulations of the same curved surface. Their distance is that between chords and
// surface, which is much smaller than the edges.
TEST(SynthCohort, TheSurfaceLiesOnTheCarriedTemplate) {
  for (const SynthShape& s : default_shapes()) {
    const Mesh surface = build_mesh(s.surface), truth = build_mesh(s.truth);
    const TriangleTree tree(truth);
    double sum = 0, largest = 0;
    for (const Vec3& p : surface.positions()) {
      const double d = std::sqrt(tree.closest(p).squared_distance);
      sum += d;
      largest = std::max(largest, d);
    }
    const double edge = mean_edge_length(surface);
    EXPECT_LT(sum / surface.vertex_count(), 0.03 * edge);
    EXPECT_LT(largest, 0.35 * edge);
  }
}

TEST(SynthCohort, TheFlowDoesNotFold) {
  const Mesh flat = build_mesh(still_truth());
  for (const SynthShape& s : default_shapes()) {
    const RigidTransform back = rigid_fit(s.truth.points, still_truth().points);
    const Mesh carried = transformed(build_mesh(s.truth), back);
    for (FaceId f : carried.faces()) {
      EXPECT_GT(unit_normal(carried.triangle(f)).dot(unit_normal(flat.triangle(f))), 0);
      EXPECT_GT(area(carried.triangle(f)), 0.1 * area(flat.triangle(f)));
    }
  }
}

// Whether the open segment from a to b passes through the triangle.
bool pierces(const Vec3& a, const Vec3& b, const std::array<Vec3, 3>& t) {
  const Vec3 n = area_vector(t);
  const double da = n.dot(a - t[0]), db = n.dot(b - t[0]);
  if (da * db >= 0) return false;
  const Vec3 p = a + da / (da - db) * (b - a);
  for (std::size_t k = 0; k < 3; ++k)
    if (n.dot((t[(k + 1) % 3] - t[k]).cross(p - t[k])) <= 0) return false;
  return true;
}

TEST(SynthCohort, SurfacesDoNotIntersectThemselves) {
  for (const SynthShape& s : default_shapes()) {
    const Mesh mesh = build_mesh(s.surface);
    const TriangleTree tree(mesh);
    int piercings = 0;
    for (EdgeId e : mesh.edges()) {
      const VertexId a = mesh.from(mesh.halfedge(e)), b = mesh.to(mesh.halfedge(e));
      for (FaceId f :
           tree.faces_within(0.5 * (mesh.position(a) + mesh.position(b)), 0.5 * edge_length(mesh, e))) {
        const auto corners = mesh.corners(f);
        if (std::ranges::find(corners, a) != corners.end() || std::ranges::find(corners, b) != corners.end())
          continue;
        piercings += pierces(mesh.position(a), mesh.position(b), mesh.triangle(f)) ? 1 : 0;
      }
    }
    EXPECT_EQ(piercings, 0);
  }
}

double smallest_angle(const std::array<Vec3, 3>& t) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 u = t[(k + 1) % 3] - t[k], v = t[(k + 2) % 3] - t[k];
    smallest = std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)));
  }
  return smallest;
}

TEST(SynthCohort, HasNoNeedles) {
  constexpr double fifteen_degrees = 0.26;
  for (const SynthShape& s : default_shapes()) {
    const Mesh mesh = build_mesh(s.surface);
    for (FaceId f : mesh.faces()) EXPECT_GT(smallest_angle(mesh.triangle(f)), fifteen_degrees);
  }
}

// Correlation of the order of vertices with a coordinate.
double order_correlation(const std::vector<Vec3>& points, int coordinate) {
  const double n = static_cast<double>(points.size());
  double mean = 0, cross = 0, variance = 0;
  for (const Vec3& p : points) mean += p[coordinate] / n;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double rank = (static_cast<double>(i) - (n - 1) / 2) / n;
    cross += rank * (points[i][coordinate] - mean);
    variance += std::pow(points[i][coordinate] - mean, 2);
  }
  return cross / std::sqrt(variance * n / 12);
}

TEST(SynthCohort, NoTraceOfTheTemplateIsLeft) {
  const auto& shapes = default_shapes();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const auto& points = shapes[i].surface.points;
    for (int k = 0; k < 3; ++k) EXPECT_LT(std::abs(order_correlation(points, k)), 0.05);
    double step = 0;  // from each vertex to the next: as far as between any two vertices
    for (std::size_t v = 1; v < points.size(); ++v) step += (points[v] - points[v - 1]).norm();
    EXPECT_GT(step / static_cast<double>(points.size()), 25);
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(shapes[i].surface.triangles, shapes[j].surface.triangles);
  }
}

// After the true correspondence maps one shape to another, their vertices do not coincide, because the
// triangulations are independent.
TEST(SynthCohort, TriangulationsAreIndependent) {
  SynthOptions o = small(2);
  o.amplitude_mm = 0;
  const auto shapes = synth_cohort(o, RunContext());
  const RigidTransform motion = rigid_fit(shapes[1].truth.points, shapes[0].truth.points);
  const auto moved = transformed(shapes[1].surface.points, motion);
  const double edge = mean_edge_length(build_mesh(shapes[0].surface));
  double nearest_sum = 0;
  for (const Vec3& p : moved) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& q : shapes[0].surface.points) nearest = std::min(nearest, (p - q).norm());
    nearest_sum += nearest;
  }
  // For independent points, the distance to the nearest one is about 0.4 edges.
  EXPECT_GT(nearest_sum / static_cast<double>(moved.size()), 0.3 * edge);
}

TEST(SynthCohort, ThePoseIsAnyPose) {
  SynthOptions o = small(12);
  o.amplitude_mm = 0;
  o.vertices = 1500;
  const auto shapes = synth_cohort(o, RunContext());
  const auto& first = shapes[0].truth.points;
  Vec3 low = Vec3::Constant(1e9), high = -low;
  double largest_angle = 0;
  std::set<int> octants;
  for (const SynthShape& s : shapes) {
    const RigidTransform motion = rigid_fit(first, s.truth.points);
    EXPECT_LT((motion * first[7] - s.truth.points[7]).norm(), 1e-9);  // without deformation, a rigid motion
    EXPECT_NEAR(motion.linear().determinant(), 1, 1e-9);
    largest_angle = std::max(largest_angle, Eigen::AngleAxisd(motion.linear()).angle());
    const Vec3 axis = motion.linear().col(2);
    octants.insert((axis.x() > 0 ? 1 : 0) + (axis.y() > 0 ? 2 : 0) + (axis.z() > 0 ? 4 : 0));
    const Vec3 centre = std::accumulate(s.truth.points.begin(), s.truth.points.end(), Vec3(Vec3::Zero())) /
                        static_cast<double>(s.truth.points.size());
    low = low.cwiseMin(centre);
    high = high.cwiseMax(centre);
  }
  EXPECT_GT(largest_angle, 2.5);
  EXPECT_GE(octants.size(), 5u);
  EXPECT_LT(low.maxCoeff(), -80);
  EXPECT_GT(high.minCoeff(), 80);
  EXPECT_GT(low.minCoeff(), -260);
  EXPECT_LT(high.maxCoeff(), 260);
}

void expect_same(const SynthShape& a, const SynthShape& b) {
  EXPECT_EQ(a.surface.points, b.surface.points);
  EXPECT_EQ(a.surface.triangles, b.surface.triangles);
  EXPECT_EQ(a.truth.points, b.truth.points);
}

TEST(SynthCohort, ItemsDependNeitherOnThreadsNorOnTheirNumber) {
  for (int modes : {0, 4}) {
    SynthOptions full = small(2), part = small(1);
    full.modes = part.modes = modes;
    const auto a = synth_cohort(full, RunContext(1)), b = synth_cohort(full, RunContext(2)),
               c = synth_cohort(part, RunContext(1));
    for (std::size_t i = 0; i < 2; ++i) expect_same(a[i], b[i]);
    expect_same(a[0], c[0]);
  }
}

TEST(SynthCohort, SeedsDiffer) {
  const auto a = synth_cohort(small(1, 1), RunContext()), b = synth_cohort(small(1, 2), RunContext());
  EXPECT_NE(a[0].surface.points, b[0].surface.points);
  EXPECT_NE(a[0].truth.points, b[0].truth.points);
}

// The displacements of the truth from the undeformed template, as columns. Rigid motions are removed, also to
// first order.
Eigen::MatrixXd displacements(const SynthOptions& options) {
  const auto& base = still_truth().points;
  const auto shapes = synth_cohort(options, RunContext());
  Eigen::MatrixXd d(3 * static_cast<Eigen::Index>(base.size()), options.shapes);
  for (int i = 0; i < options.shapes; ++i) {
    const auto& points = shapes[i].truth.points;
    const RigidTransform back = rigid_fit(points, base);
    for (std::size_t v = 0; v < base.size(); ++v)
      d.block<3, 1>(3 * static_cast<Eigen::Index>(v), i) = back * points[v] - base[v];
  }
  return d;
}

TEST(SynthCohort, ModesSpanThatManyDirections) {
  SynthOptions o = small(4, 3);
  o.vertices = 1500;
  o.amplitude_mm = 1e-4;  // so small that the flow is linear in its field
  for (int modes : {1, 3}) {
    o.modes = modes;
    const Eigen::MatrixXd d = displacements(o);
    const Eigen::VectorXd s =
        Eigen::MatrixXd(d.transpose() * d).selfadjointView<Eigen::Lower>().eigenvalues().cwiseAbs();
    std::vector<double> sorted(s.data(), s.data() + s.size());
    std::ranges::sort(sorted, std::greater{});
    EXPECT_GT(sorted[modes - 1], 1e-4 * sorted[0]);
    EXPECT_LT(sorted[modes], 1e-8 * sorted[0]);
  }
  o.modes = 0;
  const Eigen::MatrixXd d = displacements(o);
  const Eigen::VectorXd s = Eigen::MatrixXd(d.transpose() * d).selfadjointView<Eigen::Lower>().eigenvalues();
  EXPECT_GT(s.minCoeff(), 1e-3 * s.maxCoeff());
}

TEST(SynthCohort, AmplitudeIsTheRmsDisplacementOfACoordinate) {
  SynthOptions o = small(3, 8);
  o.vertices = 1500;
  o.modes = 0;
  o.correlation_mm = 6;  // many independent patches, and little of the displacement is a rigid motion
  o.amplitude_mm = 0.5;
  const Eigen::MatrixXd d = displacements(o);
  EXPECT_NEAR(std::sqrt(d.squaredNorm() / static_cast<double>(d.size())), 0.5, 0.05);
}

TEST(SynthCohort, RefusesOptionsOutOfRange) {
  const RunContext ctx;
  EXPECT_THROW(synth_cohort({.shapes = 0}, ctx), InvalidInput);
  EXPECT_THROW(synth_cohort({.modes = -1}, ctx), InvalidInput);
  EXPECT_THROW(synth_cohort({.amplitude_mm = -1}, ctx), InvalidInput);
  EXPECT_THROW(synth_cohort({.amplitude_mm = std::nan("")}, ctx), InvalidInput);
  EXPECT_THROW(synth_cohort({.correlation_mm = 0}, ctx), InvalidInput);
  EXPECT_THROW(synth_cohort({.vertices = 100}, ctx), InvalidInput);
}

TEST(SynthCohort, CanBeCancelled) {
  const RunContext ctx(1);
  ctx.request_stop();
  EXPECT_THROW(synth_cohort(small(2), ctx), Cancelled);
}

}  // namespace
}  // namespace foramen
