# Installs the library, its public headers, the command line tool, and what find_package and pkg-config need.
include(CMakePackageConfigHelpers)

set(quoin_config_dir "${CMAKE_INSTALL_LIBDIR}/cmake/quoin")

install(TARGETS quoin EXPORT quoin-targets)
if(TARGET quoin-cli)
  install(TARGETS quoin-cli)
endif()
install(DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/include/quoin" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
  FILES_MATCHING PATTERN "*.h")
install(FILES "${generated_include}/quoin/version.h" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/quoin")
install(FILES "${CMAKE_CURRENT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

install(EXPORT quoin-targets NAMESPACE quoin:: DESTINATION "${quoin_config_dir}")
configure_package_config_file(cmake/quoin-config.cmake.in quoin-config.cmake
  INSTALL_DESTINATION "${quoin_config_dir}")
write_basic_package_version_file(quoin-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_CURRENT_BINARY_DIR}/quoin-config.cmake"
  "${CMAKE_CURRENT_BINARY_DIR}/quoin-config-version.cmake"
  DESTINATION "${quoin_config_dir}")

# A static library passes its own dependencies on to whoever links it; a shared one carries them.
if(BUILD_SHARED_LIBS)
  set(quoin_pc_requires "Requires.private")
else()
  set(quoin_pc_requires "Requires")
endif()
file(RELATIVE_PATH quoin_pc_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
configure_file(cmake/quoin.pc.in quoin.pc @ONLY)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/quoin.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
