# Finds HDF5's C library for one thread, as Debian's libhdf5-dev has it: the target Quadtree_mesh_2_hdf5, if it is there.
# CMake's own FindHDF5 wants a C compiler. With an empty QUADTREE_MESH_2_HDF5_LIBRARY none is looked for.
find_path(QUADTREE_MESH_2_HDF5_INCLUDE hdf5.h PATH_SUFFIXES hdf5/serial)
find_library(QUADTREE_MESH_2_HDF5_LIBRARY NAMES hdf5_serial hdf5)
mark_as_advanced(QUADTREE_MESH_2_HDF5_INCLUDE QUADTREE_MESH_2_HDF5_LIBRARY)
if(QUADTREE_MESH_2_HDF5_INCLUDE AND QUADTREE_MESH_2_HDF5_LIBRARY)
  add_library(Quadtree_mesh_2_hdf5 INTERFACE)
  target_include_directories(Quadtree_mesh_2_hdf5 SYSTEM INTERFACE ${QUADTREE_MESH_2_HDF5_INCLUDE})
  target_link_libraries(Quadtree_mesh_2_hdf5 INTERFACE ${QUADTREE_MESH_2_HDF5_LIBRARY})
  target_compile_definitions(Quadtree_mesh_2_hdf5 INTERFACE CGAL_LINKED_WITH_HDF5)
endif()
