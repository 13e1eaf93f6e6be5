# install() and the exported package: find_package(isolaw) in another project.
include(CMakePackageConfigHelpers)
install(TARGETS isolaw EXPORT isolaw-targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/isolaw DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/rules DESTINATION ${CMAKE_INSTALL_DATADIR}/isolaw FILES_MATCHING PATTERN "*.toml")
install(EXPORT isolaw-targets NAMESPACE isolaw:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/isolaw)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/isolaw-config.cmake.in
  ${PROJECT_BINARY_DIR}/isolaw-config.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/isolaw)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/isolaw-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/isolaw-config.cmake ${PROJECT_BINARY_DIR}/isolaw-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/isolaw)
