#include "foramen/io/mesh_file.hpp"
