#include "findings/papers.hpp"

namespace foramen {
namespace {

// \cite becker2011
constexpr Paper becker{
    "M. Becker, M. Kirschner, S. Fuhrmann, S. Wesarg: Automatic Construction of Statistical Shape Models for "
    "Vertebrae. MICCAI 2011",
    "the method: loops, map to the torus, energy of correspondence, resampling of the mean"};
// \cite erickson2005
constexpr Paper erickson{
    "J. Erickson, K. Whittlesey: Greedy Optimal Homotopy and Homology Generators. SODA 2005",
    "the two loops"};
// \cite brett2000
constexpr Paper brett{
    "A. D. Brett, C. J. Taylor: Construction of 3D Shape Models of Femoral Articular Cartilage Using "
    "Harmonic Maps. MICCAI 2000",
    "the baseline: landmarks carried to closest points"};
// \cite fuhrmann2010
constexpr Paper fuhrmann{
    "S. Fuhrmann, J. Ackermann, T. Kalbe, M. Goesele: Direct Resampling for Isotropic Surface Remeshing. VMV "
    "2010",
    "landmarks, denser where the mean is curved"};
// \cite gower1975
constexpr Paper gower{"J. C. Gower: Generalized Procrustes Analysis. Psychometrika 40(1), 1975",
                      "alignment of the shapes"};
// \cite cootes1995
constexpr Paper cootes{
    "T. F. Cootes, C. J. Taylor, D. H. Cooper, J. Graham: Active Shape Models - Their Training and "
    "Application. Computer Vision and Image Understanding 61, 1995",
    "the model: mean, modes, scores"};
// \cite thodberg2003
constexpr Paper thodberg{"H. H. Thodberg: Minimum Description Length Shape and Appearance Models. IPMI 2003",
                         "the last rounds of registration, by description length"};
// \cite davies2008
constexpr Paper davies{
    "R. H. Davies, C. J. Twining, C. J. Taylor: Statistical Models of Shape: Optimisation and Evaluation. "
    "Springer 2008",
    "the measures: compactness, generalization, specificity"};

}  // namespace

std::vector<Paper> papers_used(const RunOptions& options) {
  std::vector<Paper> papers{becker, erickson};
  if (options.method() == Method::icp) papers.push_back(brett);
  papers.insert(papers.end(), {fuhrmann, gower, cootes});
  if (options.objective() == "description") papers.push_back(thodberg);
  papers.push_back(davies);
  return papers;
}

}  // namespace foramen
