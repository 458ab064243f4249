#include "foramen/io/statismo_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>

#include <Eigen/Eigenvalues>

#include "foramen/core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/hdf5_file.hpp"
#include "io/hdf5_json_file.hpp"
#include "io/single_precision.hpp"

namespace foramen {
namespace {

// Rounding to single precision changes the lengths of unit columns by about 1e-6. Columns that are off by
// much more come from version 0.8, which scaled them by standard deviations.
constexpr double orthonormality_tolerance = 1e-3;
constexpr const char* weights_path = "/foramen/landmarkWeights";

H5Matrix<float> single_precision(const Eigen::MatrixXd& matrix) {
  const H5Matrix<double> rows = h5_matrix(matrix);
  return {rows.rows, rows.cols, {rows.values.begin(), rows.values.end()}};
}

std::vector<float> single_precision(const Eigen::VectorXd& vector) {
  const Eigen::VectorXf rounded = vector.cast<float>();
  return {rounded.begin(), rounded.end()};
}

Eigen::VectorXd eigen_vector(const std::vector<float>& values) {
  return Eigen::Map<const Eigen::VectorXf>(values.data(), static_cast<Eigen::Index>(values.size()))
      .cast<double>();
}

template <class T, class Triples>
H5Matrix<T> columns(const Triples& triples) {
  const std::size_t n = triples.size();
  H5Matrix<T> out{3, n, std::vector<T>(3 * n)};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      out.values[k * n + i] = static_cast<T>(triples[i][static_cast<Eigen::Index>(k)]);
  return out;
}

bool is_positive(const std::vector<double>& weights) {
  return std::all_of(weights.begin(), weights.end(), [](double w) { return w > 0 && std::isfinite(w); });
}

bool is_orthonormal(const Eigen::MatrixXd& basis) {
  const Eigen::Index modes = basis.cols();
  const Eigen::MatrixXd gram = basis.transpose() * basis;
  return modes == 0 ||
         (gram - Eigen::MatrixXd::Identity(modes, modes)).cwiseAbs().maxCoeff() < orthonormality_tolerance;
}

// With A = B diag(sqrt(v)) = U S V^T the covariance is A A^T = U S^2 U^T, and A s = U S (V^T s). V and S come
// from A^T A, which is small.
void to_principal_components(StatismoModel& model) {
  const Eigen::MatrixXd scaled = model.basis * model.variance.cwiseSqrt().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled.transpose() * scaled);
  const Eigen::VectorXd variance = solver.eigenvalues().reverse();
  const Eigen::MatrixXd directions = solver.eigenvectors().rowwise().reverse();
  // Numbers in single precision leave less than this of a mode that has no variance.
  constexpr double smallest_share = 1e-12;
  Eigen::Index kept = 0;
  while (kept < variance.size() && variance[kept] > 0 && variance[kept] > smallest_share * variance[0])
    ++kept;
  model.variance = variance.head(kept);
  model.basis = scaled * directions.leftCols(kept) * model.variance.cwiseSqrt().cwiseInverse().asDiagonal();
  if (model.scores.cols() > 0) model.scores = (directions.leftCols(kept).transpose() * model.scores).eval();
}

class ModelCheck {
 public:
  ModelCheck(const std::filesystem::path& path, const StatismoModel& model) : path_(path), m_(model) {}
  void run() const {
    const auto points = static_cast<Eigen::Index>(m_.points.size());
    const Eigen::Index modes = m_.variance.size(), shapes = m_.scores.cols();
    expect(points > 0 && !m_.triangles.empty() && modes > 0, "it has no points, triangles or modes");
    expect(m_.mean.size() == 3 * points, "its mean has not three numbers a point");
    expect(m_.basis.rows() == 3 * points && m_.basis.cols() == modes,
           "its basis is not three rows a point by one column a mode");
    expect(shapes == 0 || m_.scores.rows() == modes, "its scores have not one row a mode");
    expect(m_.shape_uris.empty() || shapes == 0 || std::ssize(m_.shape_uris) == shapes,
           "it names another number of shapes than it has scores of");
    expect(finite(m_.mean) && finite(m_.basis) && finite(m_.variance) && finite(m_.scores) &&
               std::isfinite(m_.noise_variance) &&
               std::all_of(m_.points.begin(), m_.points.end(), [](const Vec3& p) { return finite(p); }),
           "a value is not a finite number in single precision");
    expect(m_.landmark_weights.empty() || std::ssize(m_.landmark_weights) == points,
           "it has another number of landmark weights than points");
    expect(is_positive(m_.landmark_weights), "a landmark weight is not positive and finite");
    for (const auto& triangle : m_.triangles)
      for (int corner : triangle)
        expect(corner >= 0 && corner < points, "a triangle has a corner that does not exist");
    std::set<std::string> keys;
    for (const auto& [key, value] : m_.parameters)
      expect(!key.empty() && key != "." && key.find('/') == std::string::npos && keys.insert(key).second,
             "its parameter '" + key + "' has no usable name or comes twice");
  }

 private:
  static bool finite(const Eigen::Ref<const Eigen::MatrixXd>& values) {
    return values.cast<float>().allFinite();
  }
  void expect(bool condition, const std::string& otherwise) const {
    if (!condition) throw InvalidInput("cannot write the model " + path_.string() + ": " + otherwise);
  }
  const std::filesystem::path& path_;
  const StatismoModel& m_;
};

template <class File>
void write_representer(File& file, const StatismoModel& model) {
  file.group("/representer");
  file.attribute("/representer", "name", "vtkStandardMeshRepresenter");
  file.attribute("/representer", "version", "1.0");
  file.attribute("/representer", "datasetType", "POLYGON_MESH");
  file.matrix("/representer/points", columns<float>(model.points));
  // The indices are signed, because Scalismo cannot read the unsigned ones that statismo writes.
  std::vector<Eigen::Vector3i> cells;
  cells.reserve(model.triangles.size());
  for (const auto& t : model.triangles) cells.emplace_back(t[0], t[1], t[2]);
  file.matrix("/representer/cells", columns<std::int32_t>(cells));
  file.group("/representer/pointData");
  file.group("/representer/cellData");
}

template <class File>
void write_info(File& file, const StatismoModel& model) {
  file.string("/modelinfo/build-time", model.build_time);
  if (model.scores.cols() > 0) file.matrix("/modelinfo/scores", single_precision(model.scores));
  const std::string builder = "/modelinfo/modelBuilder-0/";
  file.string(builder + "builderName", model.builder_name);
  file.string(builder + "buildTime", model.build_time);
  file.group(builder + "dataInfo");
  for (std::size_t i = 0; i < model.shape_uris.size(); ++i)
    file.string(builder + "dataInfo/URI_" + std::to_string(i), model.shape_uris[i]);
  file.group(builder + "parameters");
  for (const auto& [key, value] : model.parameters) file.string(builder + "parameters/" + key, value);
}

// File is H5Reader or H5JsonReader.
template <class File>
class ModelReader {
 public:
  explicit ModelReader(const File& file) : file_(file) {}

  StatismoModel read() {
    check_version();
    check_kind();
    read_mesh();
    read_statistics();
    read_weights();
    read_info();
    if (!is_orthonormal(model_.basis)) {
      to_principal_components(model_);
      expect(model_.basis.allFinite() && model_.variance.allFinite(), "/model/pcaBasis",
             "has numbers too large to compute with");
      model_.notes.emplace_back(
          "the columns of its basis are not orthonormal; the principal components of the same covariance "
          "were taken instead");
    }
    return std::move(model_);
  }

 private:
  void check_version() const {
    if (!file_.has("/version/majorVersion") || !file_.has("/version/minorVersion"))
      file_.refuse("/version", "is missing, as in models before version 0.9, which are not read");
    const auto major = file_.template scalar<std::int32_t>("/version/majorVersion");
    const auto minor = file_.template scalar<std::int32_t>("/version/minorVersion");
    if (!(major == 1 || (major == 0 && minor == 9)))
      file_.refuse("/version",
                   "is " + std::to_string(major) + "." + std::to_string(minor) + ", not 0.9 or 1.x");
  }

  void check_kind() const {
    const std::string kind = file_.attribute("/representer", "datasetType");
    if (kind != "POLYGON_MESH") file_.refuse("/representer", "is a " + kind + ", not a POLYGON_MESH");
  }

  void expect(bool condition, const std::string& path, const std::string& otherwise) const {
    if (!condition) file_.refuse(path, otherwise);
  }

  void read_mesh() {
    const auto points = file_.template matrix<float>("/representer/points");
    expect(points.rows == 3 && points.cols > 0 && points.cols <= most_points_, "/representer/points",
           "has " + std::to_string(points.rows) + " rows and " + std::to_string(points.cols) + " columns");
    const std::size_t n = points.cols;
    for (std::size_t i = 0; i < n; ++i) {
      const auto at = [&](std::size_t k) { return static_cast<double>(points.values[k * n + i]); };
      model_.points.emplace_back(at(0), at(1), at(2));
      expect(model_.points.back().allFinite(), "/representer/points",
             "point " + std::to_string(i) + " is not finite");
    }
    const auto cells = file_.template matrix<std::int32_t>("/representer/cells");
    expect(cells.rows == 3 && cells.cols > 0, "/representer/cells",
           "has " + std::to_string(cells.rows) + " rows and " + std::to_string(cells.cols) + " columns");
    for (std::size_t f = 0; f < cells.cols; ++f) {
      std::array<int, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        triangle[k] = cells.values[k * cells.cols + f];
        expect(triangle[k] >= 0 && static_cast<std::size_t>(triangle[k]) < n, "/representer/cells",
               "triangle " + std::to_string(f) + " uses point " + std::to_string(triangle[k]) + " of " +
                   std::to_string(n));
      }
      model_.triangles.push_back(triangle);
    }
  }

  void read_statistics() {
    const auto numbers = static_cast<Eigen::Index>(3 * model_.points.size());
    model_.mean = eigen_vector(file_.template vector<float>("/model/mean"));
    expect(model_.mean.size() == numbers, "/model/mean",
           "has " + std::to_string(model_.mean.size()) + " numbers instead of " + std::to_string(numbers));
    expect(model_.mean.allFinite(), "/model/mean", "is not finite");
    model_.variance = eigen_vector(file_.template vector<float>("/model/pcaVariance"));
    expect(model_.variance.allFinite() && (model_.variance.array() >= 0).all(), "/model/pcaVariance",
           "has a value that is negative or not finite");
    model_.basis = eigen_matrix(file_.template matrix<float>("/model/pcaBasis"));
    expect(model_.basis.rows() == numbers && model_.basis.cols() == model_.variance.size(), "/model/pcaBasis",
           "has " + std::to_string(model_.basis.rows()) + " rows and " + std::to_string(model_.basis.cols()) +
               " columns instead of " + std::to_string(numbers) + " and " +
               std::to_string(model_.variance.size()));
    expect(model_.basis.allFinite(), "/model/pcaBasis", "is not finite");
    model_.noise_variance = static_cast<double>(file_.template scalar<float>("/model/noiseVariance"));
    expect(std::isfinite(model_.noise_variance) && model_.noise_variance >= 0, "/model/noiseVariance",
           "is negative or not finite");
  }

  void read_weights() {
    if (!file_.has(weights_path)) return;
    model_.landmark_weights = file_.template vector<double>(weights_path);
    expect(model_.landmark_weights.size() == model_.points.size(), weights_path,
           "has " + std::to_string(model_.landmark_weights.size()) + " numbers instead of " +
               std::to_string(model_.points.size()));
    expect(is_positive(model_.landmark_weights), weights_path, "has a value that is not positive and finite");
  }

  void read_info() {
    model_.build_time.clear();
    model_.builder_name.clear();
    if (file_.has("/modelinfo/build-time")) model_.build_time = file_.string("/modelinfo/build-time");
    read_scores();
    const std::string builder = "/modelinfo/modelBuilder-0";
    if (!file_.has(builder)) return;
    if (file_.has(builder + "/builderName")) model_.builder_name = file_.string(builder + "/builderName");
    const std::string data = builder + "/dataInfo/URI_";
    for (std::size_t i = 0; file_.has(builder + "/dataInfo") && file_.has(data + std::to_string(i)); ++i)
      model_.shape_uris.push_back(file_.string(data + std::to_string(i)));
    if (file_.has(builder + "/parameters"))
      for (const std::string& key : file_.children(builder + "/parameters"))
        model_.parameters.emplace_back(key, file_.string(builder + "/parameters/" + key));
  }

  // A single zero stands for "no scores" in files of statismo.
  void read_scores() {
    if (!file_.has("/modelinfo/scores")) return;
    const Eigen::MatrixXd scores = eigen_matrix(file_.template matrix<float>("/modelinfo/scores"));
    if (scores.size() == 0 || (scores.size() == 1 && scores(0, 0) == 0)) return;
    expect(scores.rows() == model_.variance.size() && scores.allFinite(), "/modelinfo/scores",
           "has " + std::to_string(scores.rows()) +
               " rows instead of one a mode, or a value that is not finite");
    model_.scores = scores;
  }

  static constexpr std::size_t most_points_ = std::numeric_limits<int>::max() / 3;
  const File& file_;
  StatismoModel model_;
};

// File is H5Writer or H5JsonWriter.
template <class File>
void write_model(File& file, const StatismoModel& model) {
  file.template scalar<std::int32_t>("/version/majorVersion", 0);
  file.template scalar<std::int32_t>("/version/minorVersion", 9);
  write_representer(file, model);
  file.template vector<float>("/model/mean", single_precision(model.mean));
  file.matrix("/model/pcaBasis", single_precision(model.basis));
  file.template vector<float>("/model/pcaVariance", single_precision(model.variance));
  file.scalar("/model/noiseVariance", static_cast<float>(model.noise_variance));
  if (!model.landmark_weights.empty()) file.template vector<double>(weights_path, model.landmark_weights);
  write_info(file, model);
}

bool is_json(const std::filesystem::path& path) { return path.extension() == ".json"; }

}  // namespace

void write_statismo(const std::filesystem::path& path, const StatismoModel& model) {
  ModelCheck(path, model).run();
  if (is_json(path)) {
    H5JsonWriter file;
    write_model(file, model);
    write_file(path, file.text());
  } else {
    write_h5(path, [&](H5Writer& file) { write_model(file, model); });
  }
}

StatismoModel in_single_precision(StatismoModel model) {
  for (Vec3& p : model.points) p = p.unaryExpr(&rounded_to_single);
  model.mean = model.mean.unaryExpr(&rounded_to_single);
  model.basis = model.basis.unaryExpr(&rounded_to_single);
  model.variance = model.variance.unaryExpr(&rounded_to_single);
  model.noise_variance = rounded_to_single(model.noise_variance);
  model.scores = model.scores.unaryExpr(&rounded_to_single);
  return model;
}

StatismoModel read_statismo(const std::filesystem::path& path) {
  const auto model_of = [](const auto& file) { return ModelReader(file).read(); };
  return is_json(path) ? model_of(H5JsonReader(path)) : read_h5(path, model_of);
}

}  // namespace foramen
