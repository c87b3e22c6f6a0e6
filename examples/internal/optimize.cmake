# What compiles fastest. clang++ reads and instantiates in half of g++'s time, and optimizes in more.
set(QUADTREE_MESH_2_QUICK_LEVEL $<IF:$<CXX_COMPILER_ID:GNU>,-Og,-O0>)

# Compiles a target by a level of optimization, or as fast as possible if it is only to be tested.
function(quadtree_mesh_2_optimize target level)
  if(QUADTREE_MESH_2_QUICK_PROGRAMS)
    set(level ${QUADTREE_MESH_2_QUICK_LEVEL})
  endif()
  # g++ 12 takes the digits of Boost's integers for uninitialized.
  target_compile_options(${target} PRIVATE $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU,Clang>>:${level}>
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endfunction()
