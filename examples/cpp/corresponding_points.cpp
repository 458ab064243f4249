// A model of corresponding points from any tool: alignment, principal components, and how well they
// generalize.
#include <cmath>
#include <cstdio>

#include <foramen/foramen.hpp>

int main() {
  // Octahedra of different heights, each rotated and translated, in place of the points of another tool.
  const std::vector<std::array<int, 3>> triangles{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                  {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  foramen::CorrespondingCohort cohort;
  cohort.triangles = triangles;
  for (int k = 0; k < 5; ++k) {
    const double height = 20 + 2 * k;
    const Eigen::AngleAxisd turn(0.7 * k, foramen::Vec3(1, 2, 3).normalized());
    std::vector<foramen::Vec3> points{{20, 0, 0},  {-20, 0, 0},    {0, 25, 0},
                                      {0, -25, 0}, {0, 0, height}, {0, 0, -height}};
    for (foramen::Vec3& p : points) p = turn * p + foramen::Vec3(50 * k, 0, 10);
    cohort.names.push_back("shape" + std::to_string(k));
    cohort.inputs.push_back(foramen::build_mesh({points, triangles}));
    cohort.corresponding.push_back(std::move(points));
  }

  const foramen::AlignedModel built = foramen::build_shape_model(cohort.corresponding, triangles);
  const Eigen::VectorXd& variance = built.model.variance();
  std::printf("first mode: %.1f %% of the variance\n", 100 * variance[0] / variance.sum());

  const foramen::Evaluation measured = foramen::evaluate(cohort, {.draws = 20}, foramen::RunContext());
  for (const foramen::ErrorsAtModes& errors : measured.leave_one_out.by_modes)
    std::printf("generalization with %d modes: %.3f mm\n", errors.modes, errors.mean_surface.mean);
  return variance[0] > 0.99 * variance.sum() ? 0 : 1;
}
