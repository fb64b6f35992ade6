# quoin_define_commit(SOURCE): compiles one source file with QUOIN_COMMIT, the git commit of this checkout.
# A new commit runs CMake again, so the value never lags behind; outside a checkout the macro stays undefined.

function(quoin_git result)
  execute_process(COMMAND git ${ARGN} WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
    OUTPUT_VARIABLE output OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    set(output "")
  endif()
  set(${result} "${output}" PARENT_SCOPE)
endfunction()

function(quoin_define_commit source)
  # A copy inside another project's repository must not report that project's commit.
  quoin_git(top rev-parse --show-toplevel)
  file(REAL_PATH "${CMAKE_CURRENT_SOURCE_DIR}" here)
  if(NOT top STREQUAL here)
    return()
  endif()
  quoin_git(commit rev-parse --verify --quiet HEAD)
  if(commit)
    set_property(SOURCE "${source}" APPEND PROPERTY COMPILE_DEFINITIONS "QUOIN_COMMIT=\"${commit}\"")
  endif()
  quoin_git(log rev-parse --git-path logs/HEAD)
  get_filename_component(log "${log}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
  if(EXISTS "${log}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${log}")
  endif()
endfunction()
