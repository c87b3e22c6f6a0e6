#include "gdal_module.h"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace gdal_module {

void* function(const char* name) {
#ifdef __APPLE__
  constexpr const char* file = "@rpath/" QUADTREE_MESH_GDAL_MODULE;
#else
  constexpr const char* file = QUADTREE_MESH_GDAL_MODULE; // found by the program's own search path
#endif
  static void* const module = dlopen(file, RTLD_NOW);
  void* const result = module == nullptr ? nullptr : dlsym(module, name);
  if (result != nullptr) return result;
  const char* const why = dlerror();
  throw std::runtime_error("the part of this program that uses GDAL cannot be loaded: " +
                           std::string(why == nullptr ? file : why));
}

} // namespace gdal_module
