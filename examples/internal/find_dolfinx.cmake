# Finds dolfinx 0.5, as Debian's libdolfinx-dev has it: the target Quadtree_mesh_2_dolfinx, if it is there. After PETSc
# and the component Distributed, whose HDF5 it takes: looking for its own it may find that for one rank, and wants a C
# compiler. Its interface changes with every release.
function(quadtree_mesh_2_find_dolfinx)
  set(CMAKE_MESSAGE_LOG_LEVEL WARNING) # it lists the files of Boost
  if(NOT TARGET hdf5::hdf5)
    add_library(hdf5::hdf5 INTERFACE IMPORTED)
    set_target_properties(hdf5::hdf5 PROPERTIES INTERFACE_LINK_LIBRARIES QuadtreeMesh::Distributed)
  endif()
  find_package(DOLFINX 0.5.2 QUIET CONFIG)
  if(NOT TARGET dolfinx)
    return()
  endif()
  add_library(Quadtree_mesh_2_dolfinx INTERFACE IMPORTED)
  target_link_libraries(Quadtree_mesh_2_dolfinx INTERFACE dolfinx)
  target_compile_features(Quadtree_mesh_2_dolfinx INTERFACE cxx_std_20)
endfunction()
quadtree_mesh_2_find_dolfinx()
