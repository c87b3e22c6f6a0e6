# Finds GDAL, as Debian's libgdal-dev has it: the target Quadtree_mesh_2_gdal, if it is there. CMake's own FindGDAL also
# runs a script for it. With an empty QUADTREE_MESH_2_GDAL_LIBRARY none is looked for.
find_path(QUADTREE_MESH_2_GDAL_INCLUDE gdal.h PATH_SUFFIXES gdal)
find_library(QUADTREE_MESH_2_GDAL_LIBRARY NAMES gdal)
mark_as_advanced(QUADTREE_MESH_2_GDAL_INCLUDE QUADTREE_MESH_2_GDAL_LIBRARY)
if(QUADTREE_MESH_2_GDAL_INCLUDE AND QUADTREE_MESH_2_GDAL_LIBRARY)
  add_library(Quadtree_mesh_2_gdal INTERFACE)
  target_include_directories(Quadtree_mesh_2_gdal SYSTEM INTERFACE ${QUADTREE_MESH_2_GDAL_INCLUDE})
  target_link_libraries(Quadtree_mesh_2_gdal INTERFACE ${QUADTREE_MESH_2_GDAL_LIBRARY})
  target_compile_definitions(Quadtree_mesh_2_gdal INTERFACE CGAL_LINKED_WITH_GDAL)
endif()
