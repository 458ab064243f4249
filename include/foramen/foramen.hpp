#pragma once
/// \file
/// The whole way from surfaces to an evaluated statistical shape model:
///
///     std::vector<foramen::Shape> shapes;                       // closed surfaces of genus 1, mm
///     for (...) shapes.push_back({"L1_07", foramen::mesh_from_matrices(points, triangles)});
///     const foramen::RunContext ctx;                            // all threads, no progress
///
///     foramen::Correspondence c = foramen::correspond(shapes, {}, ctx);
///     const foramen::CohortRegistration registration = c.registration;
///     const foramen::Landmarks l = foramen::place_landmarks(shapes, std::move(c), {.count = 4000}, ctx);
///     const foramen::AlignedModel m = foramen::build_shape_model(l.points, l.mesh.triangles);
///     const foramen::Evaluation e = foramen::evaluate(foramen::corresponding_cohort(shapes, l), {}, ctx);
///
/// build_model() takes the first three steps at once. Every function throws the errors of core/error.hpp.

#include "foramen/apply/complete_surface.hpp"
#include "foramen/apply/measure_shape.hpp"
#include "foramen/apply/project_shape.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/mesh.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/core/shape.hpp"
#include "foramen/correspond/correspond.hpp"
#include "foramen/correspond/mean_registrar.hpp"
#include "foramen/evaluate/evaluate.hpp"
#include "foramen/landmarks/place_landmarks.hpp"
#include "foramen/model/build_shape_model.hpp"
#include "foramen/stages/build_model.hpp"
#include "foramen/stages/refit.hpp"
