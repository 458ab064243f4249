#pragma once
/// \file
/// The first stage: every shape of a cohort mapped to one torus, or aligned for the ICP baseline.

#include <span>
#include <string>
#include <vector>

#include "foramen/core/shape.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "foramen/match/align.hpp"

namespace foramen {

/// How correspondence is established.
enum class Method {
  torus,  ///< correspondence through maps to a common flat torus
  icp,  ///< the baseline (Brett and Taylor 2000): landmarks of the remeshed reference to their closest points
};
template <>
struct EnumWords<Method> {
  static constexpr std::pair<std::string_view, Method> all[] = {{"torus", Method::torus},
                                                                {"icp", Method::icp}};
};

/// The correspondence energy of the maps of Method::torus.
enum class Objective {
  /// Distance to points of a template that is bent onto the shape; the mean becomes the template:
  /// register_group().
  surface,
  neighbours,  ///< the soft neighbours of the paper on the reference [becker2011 Eq. 4]: register_shape()
};
template <>
struct EnumWords<Objective> {
  static constexpr std::pair<std::string_view, Objective> all[] = {{"surface", Objective::surface},
                                                                   {"neighbours", Objective::neighbours}};
};

struct CorrespondOptions {
  Method method = Method::torus;
  Objective objective = Objective::surface;
  /// Name of a shape, or "auto": the first shape of rank_references() that can be mapped.
  std::string reference = "auto";
  RegisterGroupOptions group = {};    ///< for all shapes with Objective::surface
  RegisterOptions registration = {};  ///< for the reference, and with Objective::neighbours for all shapes
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<CorrespondOptions> auto& o) {
  visit(o.method, {.name = "method", .meaning = "torus maps, or the ICP baseline"});
  visit(o.objective, {.name = "objective",
                      .meaning = "what draws the maps together: points of the bent mean's surface, or the "
                                 "paper's soft neighbours"});
  visit(o.reference, {.name = "reference", .meaning = "name of the reference shape, or auto"});
  visit(o.group, {.name = "group"});
  visit(o.registration, {.name = "registration"});
}

/// Whether the shapes are registered as a group, so that options.group is used.
bool registered_together(const CorrespondOptions& options);

/// How a shape was brought into correspondence: everything known about it except the map itself.
struct ShapeRegistration {
  std::string name;
  Alignment alignment;  ///< shape -> reference
  /// With Method::icp only the reference is mapped, and the fields below are empty for the other shapes.
  bool mapped = true;
  MapCertificate certificate = {};
  int iterations = 0;
  double initial_energy = 0, final_energy = 0;
  double distortion = 0;                               ///< area-weighted mean of Degener's energy, >= 4
  Eigen::Matrix2i homology = Eigen::Matrix2i::Zero();  ///< see transfer_homology()
  Eigen::Matrix2i seifert = Eigen::Matrix2i::Zero();   ///< of the shape's own loops
  Vec2 agreement = Vec2::Zero();                       ///< see map_agreement()
  double seconds = 0;                                  ///< computing time for this shape
};

/// A shape that failed a check, and the reason.
struct FailedShape {
  std::string name;
  Message reason;
};

/// A finished correspondence, except for the maps.
struct CohortRegistration {
  Method method = Method::torus;
  std::vector<ShapeRegistration> shapes;  ///< in the order in which the shapes were given
  std::vector<FailedShape> failed;        ///< the same
  /// Shapes that rank before the reference but could not be mapped, or by which more shapes were lost.
  std::vector<FailedShape> refused_references;
  int reference = 0;  ///< index into `shapes`
  RegistrationFrame frame;
  std::vector<double> template_motion_mm;   ///< see GroupRegistration
  std::vector<double> unexplained_shares;   ///< the same
  std::vector<double> description_lengths;  ///< the same
  double reference_seconds = 0;             ///< computing time for the choice of the reference and its map
};

/// A finished correspondence with the maps of the shapes.
struct Correspondence {
  CohortRegistration registration;
  /// One map per registered shape, of its mesh; empty for a shape that is not mapped.
  std::vector<TorusMap> maps;
};

/// There are fewer shapes than a model needs; the message lists the shapes that failed.
class TooFewShapes : public InvalidInput {
  using InvalidInput::InvalidInput;
};

/// Least number of shapes of a model. With 3 shapes, leaving one out still leaves two and thus a variation.
inline constexpr int fewest_shapes = 3;

/// Brings the shapes into correspondence. A shape that fails a check is left out with the reason, and the
/// others are continued.
///
/// The reference is mapped first; all shapes use its loops and its lattice. Then the shapes are registered
/// with each other (register_group()), or each with the reference (register_shape()), or, with Method::icp,
/// only aligned to the reference (align()). If more than 5 % of the shapes cannot be registered and the
/// reference was chosen automatically, up to two further references are tried, and the one by which the
/// fewest shapes are lost is taken.
///
/// Throws TooFewShapes if fewer than 3 shapes are given or remain, InvalidInput if the named reference is not
/// among them, ConvergenceError if no shape can be the reference.
Correspondence correspond(std::span<const Shape> shapes, const CorrespondOptions& options,
                          const RunContext& ctx);

/// Ranks the shapes (indices) from the most average one on: by the sum of the absolute deviations of log area
/// and log volume from the medians of the cohort. Ties keep the order of the shapes. Shapes with less than a
/// quarter of the median number of vertices come after the others, because loops with few vertices are not
/// carried to other shapes reliably. Shapes of more than 100 000 vertices come last, because the search for
/// their loops takes minutes.
std::vector<int> rank_references(std::span<const Shape> shapes);

}  // namespace foramen
