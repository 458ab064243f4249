// From mesh files to a model: files_to_model L1.ply L2.ply L3.ply ...
#include <cstdio>
#include <filesystem>

#include <foramen/foramen.hpp>
#include <foramen/io/mesh_file.hpp>

int main(int count, char** files) try {
  std::vector<foramen::Shape> shapes;
  for (int i = 1; i < count; ++i)
    shapes.push_back(
        {std::filesystem::path(files[i]).stem(), foramen::build_mesh(foramen::read_mesh(files[i]).soup)});
  const foramen::BuiltModel built = foramen::build_model(shapes, {}, foramen::RunContext());
  const foramen::ShapeModel& model = built.aligned.model;
  foramen::write_ply("mean.ply", {foramen::unflattened(model.mean()), model.triangles()});
  std::printf("%d landmarks, %d modes, first standard deviation %.1f mm\n", model.landmarks(), model.modes(),
              std::sqrt(model.variance()[0]));
} catch (const foramen::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
