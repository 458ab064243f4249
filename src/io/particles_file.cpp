#include "foramen/core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/named_points_text.hpp"
#include "io/shapeworks_project.hpp"

namespace foramen {

void write_particles(const std::filesystem::path& path, std::span<const Vec3> particles) {
  std::string out;
  for (const Vec3& particle : particles) {
    if (!particle.allFinite())
      throw InvalidInput("cannot write " + path.string() + ": a coordinate is not finite");
    out += io_detail::text_of(particle) + "\n";
  }
  if (out.empty()) throw InvalidInput("cannot write " + path.string() + ": there are no particles");
  write_file(path, out);
}

std::vector<Vec3> read_particles(const std::filesystem::path& path) {
  const std::string bytes = io_detail::read_bytes(path);
  const io_detail::Source source{path.string(), bytes};
  std::vector<Vec3> particles;
  io_detail::LineCursor lines(bytes);
  while (lines.next_filled()) {
    const auto particle = io_detail::point_of(lines.line());
    if (!particle)
      source.refuse(lines.place() + ": expected three numbers, found " + io_detail::in_quotes(lines.line()),
                    io_detail::remedy_export_again);
    particles.push_back(*particle);
  }
  if (particles.empty()) source.refuse("holds no particles", io_detail::remedy_export_again);
  return particles;
}

}  // namespace foramen
