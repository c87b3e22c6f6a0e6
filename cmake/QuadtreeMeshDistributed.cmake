# The component Distributed, in this project and where it is installed: the target QuadtreeMesh::Distributed, which has
# the headers with MPI, p4est and the HDF5 for several ranks. QuadtreeMesh_Distributed_FOUND says whether all are there,
# QuadtreeMesh_Distributed_MISSING what is not.
set(QuadtreeMesh_Distributed_MISSING "")

# MPI's C interface is all that is used, from C++.
if(NOT DEFINED MPI_CXX_SKIP_MPICXX)
  set(MPI_CXX_SKIP_MPICXX ON)
endif()
find_package(MPI QUIET COMPONENTS CXX)
if(NOT TARGET MPI::MPI_CXX)
  list(APPEND QuadtreeMesh_Distributed_MISSING "MPI (Debian: libopenmpi-dev, openmpi-bin)")
endif()

list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
find_package(P4est QUIET)
list(POP_FRONT CMAKE_MODULE_PATH)
if(NOT TARGET P4est::P4est)
  list(APPEND QuadtreeMesh_Distributed_MISSING "p4est (Debian: libp4est-dev)")
endif()

# That for one rank, which other programs here link, may be installed beside it.
find_path(QUADTREE_MESH_2_PARALLEL_HDF5_INCLUDE hdf5.h PATH_SUFFIXES hdf5/openmpi hdf5/mpich)
find_library(QUADTREE_MESH_2_PARALLEL_HDF5_LIBRARY NAMES hdf5_openmpi hdf5_mpich hdf5)
mark_as_advanced(QUADTREE_MESH_2_PARALLEL_HDF5_INCLUDE QUADTREE_MESH_2_PARALLEL_HDF5_LIBRARY)
set(parallel_hdf5)
if(QUADTREE_MESH_2_PARALLEL_HDF5_INCLUDE AND QUADTREE_MESH_2_PARALLEL_HDF5_LIBRARY)
  file(STRINGS ${QUADTREE_MESH_2_PARALLEL_HDF5_INCLUDE}/H5pubconf.h parallel_hdf5 REGEX "^#define H5_HAVE_PARALLEL 1")
endif()
if(NOT parallel_hdf5)
  list(APPEND QuadtreeMesh_Distributed_MISSING "HDF5 with MPI (Debian: libhdf5-openmpi-dev)")
endif()

if(QuadtreeMesh_Distributed_MISSING)
  list(JOIN QuadtreeMesh_Distributed_MISSING ", " QuadtreeMesh_Distributed_MISSING)
  set(QuadtreeMesh_Distributed_FOUND FALSE)
  return()
endif()
set(QuadtreeMesh_Distributed_FOUND TRUE)
if(NOT TARGET QuadtreeMesh::Distributed)
  add_library(QuadtreeMesh::Distributed INTERFACE IMPORTED GLOBAL)
  target_include_directories(QuadtreeMesh::Distributed SYSTEM INTERFACE ${QUADTREE_MESH_2_PARALLEL_HDF5_INCLUDE})
  target_link_libraries(QuadtreeMesh::Distributed INTERFACE
    QuadtreeMesh::QuadtreeMesh P4est::P4est ${QUADTREE_MESH_2_PARALLEL_HDF5_LIBRARY} MPI::MPI_CXX)
  target_compile_definitions(QuadtreeMesh::Distributed INTERFACE
    CGAL_LINKED_WITH_HDF5 OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
endif()
