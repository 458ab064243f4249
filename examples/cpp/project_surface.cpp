// A new surface projected on a model: its landmarks, its scores, and its distance to the closest shape of the
// model.
#include <cstdio>

#include <foramen/foramen.hpp>
#include <foramen/spatial/surface_distance.hpp>
#include <foramen/synth/synth_cohort.hpp>

int main() {
  const foramen::RunContext ctx;
  std::vector<foramen::Shape> shapes;
  for (const foramen::SynthShape& shape :
       foramen::synth_cohort({.shapes = 5, .seed = 7, .vertices = 2000}, ctx))
    shapes.push_back({"synth" + std::to_string(shapes.size()), foramen::build_mesh(shape.surface)});
  const foramen::Shape newcomer = shapes.back();
  shapes.pop_back();

  const foramen::BuiltModel built =
      foramen::build_model(shapes, {.landmarks = {.count = 600, .spread = {.grid_points = 8000}}}, ctx);
  const foramen::MeanRegistrar registrar(foramen::mean_surface(built), built.aligned.alignment.aligned, ctx);
  const std::vector<foramen::Vec3> landmarks = registrar.landmarks_on(newcomer.mesh, ctx);
  const foramen::ProjectedShape projected =
      foramen::project_shape(landmarks, built.aligned, foramen::ScaleMode::keep);

  const foramen::TriangleTree surface(newcomer.mesh),
      fit(foramen::build_mesh({projected.fit, built.landmarks.mesh.triangles}));
  std::printf("first score %.2f sd; mean distance of the surface to the model's fit %.2f mm\n",
              projected.scores[0], foramen::surface_distance(surface, fit).mean);
  return 0;
}
