#include "workflow/reconstruct_shapes.hpp"

#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "io/atomic_file.hpp"
#include "io/table_file.hpp"
#include "modelfiles/model_folder.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

struct NamedScores {
  std::string name;
  Eigen::VectorXd scores;  // of all modes, in standard deviations
};

// The mode, from 0, of a column "mode3".
int mode_of(const std::string& column, int modes, const std::string& file) {
  for (int m = 0; m < modes; ++m)
    if (column == "mode" + std::to_string(m + 1)) return m;
  throw IoError(file + ": the column \"" + column + "\" is no mode of this model; it has mode1 to mode" +
                std::to_string(modes));
}

// One shape a row; modes without a column are 0.
std::vector<NamedScores> read_scores(const std::string& file, int modes) {
  const Table table = read_csv(file);
  if (table.header.front() != "shape")
    throw IoError(file + ": its first column is \"" + table.header.front() +
                  "\"; it must be \"shape\", and the others mode1, mode2 ..., as in a model's scores.csv");
  std::vector<int> mode;
  for (std::size_t c = 1; c < table.header.size(); ++c) mode.push_back(mode_of(table.header[c], modes, file));
  std::vector<NamedScores> all;
  std::set<std::string> names;
  for (const auto& row : table.rows) {
    NamedScores one{row[0], Eigen::VectorXd::Zero(modes)};
    if (one.name.empty() || fs::path(one.name).filename() != one.name || !names.insert(one.name).second)
      throw IoError(file + ": the shape \"" + one.name +
                    "\" has no name for a file of its own; every row needs another, without /");
    for (std::size_t c = 0; c < mode.size(); ++c) {
      const double score = parse_number(row[c + 1]);
      if (!std::isfinite(score))
        throw IoError(file + ": the shape \"" + one.name + "\" has a score that is not finite; correct it");
      one.scores[mode[c]] = score;
    }
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace

int reconstruct_shapes(const ReconstructRequest& request, const RunContext& ctx) {
  const LoadedModel loaded = load_model(request.model);
  const std::vector<NamedScores> all = read_scores(request.scores.string(), loaded.model.modes());
  make_folder(request.output);
  for (const NamedScores& one : all) {
    ctx.check();
    const Eigen::VectorXd shape =
        loaded.model.reconstruct(one.scores.cwiseProduct(loaded.model.variance().cwiseSqrt()));
    write_ply(request.output / (one.name + ".ply"), {unflattened(shape), loaded.model.triangles()},
              loaded.space);
  }
  return static_cast<int>(all.size());
}

}  // namespace foramen
