# Defaults of a build of this project by itself; a project that embeds Quoin keeps its own.

if(PROJECT_IS_TOP_LEVEL)
  get_property(multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
  if(NOT CMAKE_BUILD_TYPE AND NOT multi_config)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
  endif()
  find_program(CCACHE_PROGRAM ccache)
  if(CCACHE_PROGRAM AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
    # Without this it does not cache what uses precompiled headers.
    set(CMAKE_CXX_COMPILER_LAUNCHER
      "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros "${CCACHE_PROGRAM}")
  endif()
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

# Contraction to fused multiply-add would break the derivations of the error bounds.
add_compile_options(-ffp-contract=off -Wall -Wextra -Wshadow)
# GCC 12 warns of std::string's own memcpy (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  add_compile_options(-Wno-restrict)
endif()

# quoin_precompile(TARGET HEADER...): reads once what takes most of the time to read, for all sources of the target. A
# source still includes what it uses: CMAKE_DISABLE_PRECOMPILE_HEADERS shows where one does not.
function(quoin_precompile target)
  # GCC forgets which of it are system headers.
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow)
  endif()
  target_precompile_headers(${target} PRIVATE
    <algorithm> <array> <functional> <map> <memory> <optional> <span> <string> <variant> <vector>
    <boost/multiprecision/gmp.hpp> <tbb/parallel_for.h> <tbb/task_arena.h> ${ARGN})
endfunction()

# quoin_add_room(FOLDER OPTION): adds the folder when the option is on and the folder has a CMakeLists.txt.
function(quoin_add_room folder switch)
  if(${switch} AND EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/CMakeLists.txt")
    add_subdirectory("${folder}")
  endif()
endfunction()
