# Every public header compiles by itself, and may be included twice.
file(GLOB headers RELATIVE ${PROJECT_SOURCE_DIR}/include CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/include/CGAL/*.h
  ${PROJECT_SOURCE_DIR}/include/CGAL/IO/*.h
  ${PROJECT_SOURCE_DIR}/include/CGAL/Quadtree_mesh_2/*.h)
if(NOT TARGET CGAL::Eigen3_support)
  list(REMOVE_ITEM headers CGAL/indexed_mesh_to_matrices.h)
endif()
if(NOT TARGET nlohmann_json::nlohmann_json)
  list(REMOVE_ITEM headers CGAL/IO/read_GeoJSON.h)
endif()
set(sources)
foreach(header IN LISTS headers)
  string(REPLACE "/" "_" name ${header})
  set(source ${CMAKE_CURRENT_BINARY_DIR}/standalone_headers/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "#include <@header@>\n#include <@header@>\n" @ONLY)
  list(APPEND sources ${source})
endforeach()
add_library(standalone_headers OBJECT ${sources})
target_link_libraries(standalone_headers PRIVATE Quadtree_mesh_2_program)
target_compile_options(standalone_headers PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-O0>)
if(TARGET nlohmann_json::nlohmann_json)
  target_link_libraries(standalone_headers PRIVATE nlohmann_json::nlohmann_json)
endif()
