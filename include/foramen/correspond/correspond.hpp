#pragma once
/// \file
/// The first stage: every shape of a cohort mapped to one torus, or aligned for the ICP baseline.

#include <span>
#include <string>
#include <vector>

#include "foramen/core/shape.hpp"
#include "foramen/correspond/group_options.hpp"
#include "foramen/correspond/register_options.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/match/align.hpp"

namespace foramen {

enum class Method {
  torus,  ///< correspondence through maps to a common flat torus
  icp,  ///< the baseline (Brett and Taylor 2000): landmarks of the remeshed reference to their closest points
};
template <>
struct EnumWords<Method> {
  static constexpr std::pair<std::string_view, Method> all[] = {{"torus", Method::torus},
                                                                {"icp", Method::icp}};
};

/// What draws the maps of Method::torus into correspondence.
enum class Objective {
  surface,     ///< points of a template bent onto the shape; the template becomes the mean: register_group()
  neighbours,  ///< the paper's soft neighbours on the reference [becker2011 Eq. 4]: register_shape()
};
template <>
struct EnumWords<Objective> {
  static constexpr std::pair<std::string_view, Objective> all[] = {{"surface", Objective::surface},
                                                                   {"neighbours", Objective::neighbours}};
};

struct CorrespondOptions {
  Method method = Method::torus;
  Objective objective = Objective::surface;
  std::string reference = "auto";     ///< A shape's name, or auto: the first of rank_references() with a map.
  RegisterGroupOptions group = {};    ///< of all shapes with Objective::surface
  RegisterOptions registration = {};  ///< of the reference, and of all shapes with Objective::neighbours
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

/// Whether shapes are registered as a group, and options.group counts.
bool registered_together(const CorrespondOptions& options);

/// How a shape was brought into correspondence: all that is known of it but the map itself.
struct ShapeRegistration {
  std::string name;
  Alignment alignment;  ///< shape -> reference
  bool mapped = true;   ///< With Method::icp only the reference is; all that follows is then empty.
  MapCertificate certificate = {};
  int iterations = 0;
  double initial_energy = 0, final_energy = 0;
  double distortion = 0;                               ///< area-weighted mean of Degener's energy, >= 4
  Eigen::Matrix2i homology = Eigen::Matrix2i::Zero();  ///< see transfer_homology()
  Eigen::Matrix2i seifert = Eigen::Matrix2i::Zero();   ///< of the shape's own loops
  Vec2 agreement = Vec2::Zero();                       ///< see map_agreement()
  double seconds = 0;                                  ///< of this shape alone
};

/// A shape that failed a check, and why.
struct FailedShape {
  std::string name;
  Message reason;
};

/// A finished correspondence without the maps.
struct CohortRegistration {
  Method method = Method::torus;
  std::vector<ShapeRegistration> shapes;  ///< in the order in which the shapes were given
  std::vector<FailedShape> failed;        ///< the same
  /// Shapes that ranked before the reference but have no map of their own.
  std::vector<FailedShape> refused_references;
  int reference = 0;  ///< index into `shapes`
  RegistrationFrame frame;
  std::vector<double> template_motion_mm;   ///< see GroupRegistration
  std::vector<double> unexplained_shares;   ///< the same
  std::vector<double> description_lengths;  ///< the same
  double reference_seconds = 0;             ///< of the search for the reference and its map
};

struct Correspondence {
  CohortRegistration registration;
  std::vector<TorusMap> maps;  ///< one per registered shape, of its mesh; empty where a shape is not mapped
};

/// Fewer shapes than a model needs; the message lists those that failed.
class TooFewShapes : public InvalidInput {
  using InvalidInput::InvalidInput;
};

/// A model needs as many shapes. 3 is the least number of which leaving one out leaves a variation.
inline constexpr int fewest_shapes = 3;

/// Brings the shapes into correspondence. A shape that fails a check is left out with the reason, and the
/// rest go on.
///
/// The reference is mapped first; its loops and lattice are those of all shapes. Then the shapes are
/// registered with each other (register_group()), each with the reference (register_shape()), or, with
/// Method::icp, only aligned to it (align()).
///
/// Throws TooFewShapes if fewer than 3 shapes are given or remain, InvalidInput if the named reference is not
/// among them, ConvergenceError if no shape can be the reference.
Correspondence correspond(std::span<const Shape> shapes, const CorrespondOptions& options,
                          const RunContext& ctx);

/// The shapes from the most ordinary on, by a cheap rule: smallest sum of absolute deviations of log area and
/// log volume from the cohort's medians. Equals in their order; shapes of more than 100 000 vertices, whose
/// loops take minutes, last.
std::vector<int> rank_references(std::span<const Shape> shapes);

}  // namespace foramen
