#include "modelfiles/model_folder.hpp"

#include <map>

#include <gtest/gtest.h>

#include "foramen/io/statismo_file.hpp"
#include "support/temporary_folder.hpp"
#include "workflow/read_family.hpp"

namespace foramen {
namespace {

constexpr double single_precision = 1e-5;  // relative, after a few operations on numbers of 24 bits

Eigen::MatrixXd covariance(const Eigen::MatrixXd& basis, const Eigen::VectorXd& variance) {
  return basis * variance.asDiagonal() * basis.transpose();
}

class ModelFolder : public ::testing::TestWithParam<LandmarkWeights> {
 protected:
  // Made once for all tests of the same weights.
  static const BuildRecord& build() {
    static std::map<LandmarkWeights, BuildRecord> made;
    const auto found = made.find(GetParam());
    if (found != made.end()) return found->second;
    BuildOptions options = testing::small();
    options.landmarks.count = 300;
    options.model.weights = GetParam();
    return made.emplace(GetParam(), testing::family_build(options)).first->second;
  }
};

TEST_P(ModelFolder, TheModelReadBackIsTheModelBuilt) {
  const testing::TemporaryFolder folder;
  const BuildRecord& made = build();
  write_model_files(folder.path(), made, "foramen build", 1);
  const LoadedModel loaded = load_model(folder.path());
  EXPECT_EQ(loaded.model.weights(), made.built.aligned.model.weights());
  EXPECT_EQ(loaded.model.weights().empty(), GetParam() == LandmarkWeights::equal);
  ASSERT_EQ(loaded.model.modes(), made.built.aligned.model.modes());
  EXPECT_TRUE(loaded.model.mean().isApprox(made.built.aligned.model.mean(), single_precision));
  EXPECT_TRUE(loaded.model.variance().isApprox(made.built.aligned.model.variance(), single_precision));
  EXPECT_TRUE(loaded.model.basis().isApprox(made.built.aligned.model.basis(), single_precision));
  EXPECT_TRUE(loaded.scores.isApprox(training_scores(made.built.aligned), single_precision));
}

TEST_P(ModelFolder, TheModelAsWrittenIsTheModelReadBack) {
  const testing::TemporaryFolder folder;
  BuildRecord made = build();
  for (InputShape& input : made.inputs) input.space = AnatomicalSpace::ras;
  write_model_files(folder.path(), made, "foramen build", 1);
  const LoadedModel read = load_model(folder.path()), written = loaded_as_written(made, "foramen build");
  EXPECT_EQ(written.model.mean(), read.model.mean());
  EXPECT_EQ(written.model.basis(), read.model.basis());
  EXPECT_EQ(written.model.variance(), read.model.variance());
  EXPECT_EQ(written.model.weights(), read.model.weights());
  EXPECT_EQ(written.model.triangles(), read.model.triangles());
  EXPECT_EQ(written.names, read.names);
  EXPECT_EQ(written.scores, read.scores);
  EXPECT_EQ(written.space, read.space);
}

// Readers that know no weights take the file's own modes: orthonormal, of the same distribution of shapes,
// with the scores of the same shapes.
TEST_P(ModelFolder, TheFileIsRightForReadersThatKnowNoWeights) {
  const testing::TemporaryFolder folder;
  const BuildRecord& made = build();
  write_model_files(folder.path(), made, "foramen build", 1);
  const StatismoModel file = read_statismo(folder.file("model.h5"));
  const auto k = file.variance.size();
  EXPECT_LT((file.basis.transpose() * file.basis - Eigen::MatrixXd::Identity(k, k)).norm(), single_precision);
  EXPECT_TRUE(covariance(file.basis, file.variance)
                  .isApprox(covariance(made.built.aligned.model.basis(), made.built.aligned.model.variance()),
                            single_precision));
  ASSERT_EQ(file.scores.cols(), std::ssize(made.inputs));
  for (Eigen::Index i = 0; i < file.scores.cols(); ++i) {
    const Eigen::VectorXd shape =
        file.mean + file.basis * file.scores.col(i).cwiseProduct(file.variance.cwiseSqrt());
    EXPECT_TRUE(shape.isApprox(flattened(made.built.aligned.alignment.aligned[i]), single_precision));
  }
}

INSTANTIATE_TEST_SUITE_P(Weights, ModelFolder,
                         ::testing::Values(LandmarkWeights::equal, LandmarkWeights::area));

}  // namespace
}  // namespace foramen
