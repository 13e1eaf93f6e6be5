# Installs isolaw with an exported package, so that another project can call find_package(isolaw).
include(CMakePackageConfigHelpers)
install(TARGETS isolaw EXPORT isolaw-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})

# Returns the public headers: api/isolaw.hpp and every header of isolaw that it includes directly or indirectly.
function(isolaw_public_headers result)
  set(open isolaw/api/isolaw.hpp)
  set(known "")
  while(open)
    list(POP_FRONT open header)
    list(APPEND known ${header})
    set(file ${PROJECT_SOURCE_DIR}/src/${header})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(STRINGS ${file} lines REGEX "^#include \"isolaw/")
    list(TRANSFORM lines REPLACE "^#include \"([^\"]*)\".*" "\\1")
    list(APPEND open ${lines})
    list(REMOVE_DUPLICATES open)
    list(REMOVE_ITEM open ${known})
  endwhile()
  set(${result} ${known} PARENT_SCOPE)
endfunction()
isolaw_public_headers(headers)
foreach(header IN LISTS headers)
  cmake_path(GET header PARENT_PATH folder)
  install(FILES ${PROJECT_SOURCE_DIR}/src/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${folder})
endforeach()

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/LICENSES/MIT-0.txt DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/rules DESTINATION ${CMAKE_INSTALL_DATADIR}/isolaw FILES_MATCHING PATTERN "*.toml")
install(EXPORT isolaw-targets NAMESPACE isolaw:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/isolaw)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/isolaw-config.cmake.in
  ${PROJECT_BINARY_DIR}/isolaw-config.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/isolaw)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/isolaw-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/isolaw-config.cmake ${PROJECT_BINARY_DIR}/isolaw-config-version.cmake
              ${PROJECT_SOURCE_DIR}/cmake/isolaw-libraries.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/isolaw)
