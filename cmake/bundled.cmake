# Defines the same targets as cmake/dependencies.cmake, but builds the libraries from source (ISOLAW_BUNDLED). The page,
# wheels and the Debian package contain them, since they run where the libraries are not installed.
# tools/library_sources.sh fetches the sources.
set(ISOLAW_LIBRARIES ${PROJECT_BINARY_DIR}/libraries CACHE PATH "folder of tools/library_sources.sh")
set(sources bearssl expat minizip sqlite3 zlib)
# These compilers link their runtime libraries into every program, so the licences of the runtimes hold too.
if(EMSCRIPTEN)
  list(APPEND sources emscripten)
elseif(WIN32)
  list(APPEND sources g++-mingw-w64-x86-64-posix mingw-w64-x86-64-dev)
else()
  list(APPEND sources hdf5)
endif()
execute_process(COMMAND ${PROJECT_SOURCE_DIR}/tools/library_sources.sh ${ISOLAW_LIBRARIES} ${sources}
                COMMAND_ERROR_IS_FATAL ANY)
set(from ${ISOLAW_LIBRARIES})

add_library(bundled_headers INTERFACE)
target_include_directories(bundled_headers SYSTEM INTERFACE ${from}/include)
add_library(Boost::headers ALIAS bundled_headers)
add_library(CLI11::CLI11 ALIAS bundled_headers)
add_library(nlohmann_json::nlohmann_json ALIAS bundled_headers)
add_library(tomlplusplus::tomlplusplus ALIAS bundled_headers)
add_library(bundled_eigen INTERFACE)
target_include_directories(bundled_eigen SYSTEM INTERFACE ${from}/include/eigen3)
add_library(Eigen3::Eigen ALIAS bundled_eigen)
add_library(bundled_fmt INTERFACE)
target_link_libraries(bundled_fmt INTERFACE bundled_headers)
target_compile_definitions(bundled_fmt INTERFACE FMT_HEADER_ONLY)
add_library(fmt::fmt ALIAS bundled_fmt)
add_library(fmt::fmt-header-only ALIAS bundled_fmt)
if(EMSCRIPTEN)
  # The program has one thread in a browser, so the target for threads is empty.
  add_library(bundled_threads INTERFACE)
  add_library(Threads::Threads ALIAS bundled_threads)
else()
  find_package(Threads REQUIRED)
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
endif()

# Builds a library from C sources that other projects wrote. This project does not change them, so compiler warnings are
# off.
function(bundled_library name)
  add_library(${name} STATIC ${ARGN})
  target_compile_options(${name} PRIVATE -O2 -w)
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
endfunction()

set(zlib adler32 compress crc32 deflate inffast inflate inftrees trees uncompr zutil)
list(TRANSFORM zlib REPLACE "(.+)" "${from}/zlib/\\1.c")
bundled_library(bundled_zlib ${zlib})
target_include_directories(bundled_zlib SYSTEM PUBLIC ${from}/zlib)
add_library(ZLIB::ZLIB ALIAS bundled_zlib)

bundled_library(bundled_minizip ${from}/minizip/ioapi.c ${from}/minizip/unzip.c)
target_compile_definitions(bundled_minizip PRIVATE USE_FILE32API NOUNCRYPT)
target_link_libraries(bundled_minizip PUBLIC bundled_zlib)

bundled_library(bundled_expat ${from}/expat/expat/lib/xmlparse.c ${from}/expat/expat/lib/xmlrole.c ${from}/expat/expat/lib/xmltok.c)
# The compile definitions below replace the header that expat's configure script would write.
file(WRITE ${PROJECT_BINARY_DIR}/made/expat_config.h "")
target_include_directories(bundled_expat PRIVATE ${PROJECT_BINARY_DIR}/made)
target_compile_definitions(bundled_expat PRIVATE XML_NS XML_DTD XML_GE=1 XML_CONTEXT_BYTES=1024 XML_DEV_URANDOM HAVE_MEMMOVE)
target_include_directories(bundled_expat SYSTEM PUBLIC ${from}/expat/expat/lib)
add_library(EXPAT::EXPAT ALIAS bundled_expat)

bundled_library(bundled_sqlite ${from}/sqlite3/made/sqlite3.c)
# SQLite loads no extensions and maps no files into memory. On the page it needs no locks, because there is one thread.
target_compile_definitions(bundled_sqlite PRIVATE SQLITE_THREADSAFE=$<NOT:$<BOOL:${EMSCRIPTEN}>> SQLITE_OMIT_LOAD_EXTENSION
                           SQLITE_MAX_MMAP_SIZE=0)
target_include_directories(bundled_sqlite SYSTEM PUBLIC ${from}/sqlite3/made)
add_library(SQLite::SQLite3 ALIAS bundled_sqlite)

# The program needs only SHA-256 of BearSSL.
bundled_library(bundled_bearssl ${from}/bearssl/src/hash/sha2small.c ${from}/bearssl/src/codec/dec32be.c
                ${from}/bearssl/src/codec/enc32be.c)
target_include_directories(bundled_bearssl PRIVATE ${from}/bearssl/src SYSTEM PUBLIC ${from}/bearssl/inc)

set(ISOLAW_WITHOUT_PACKAGE bundled_minizip bundled_bearssl)
set(ISOLAW_MINIZIP_INCLUDE ${from})
# The page and Windows need no HDF5 (data/files/mat73_without_hdf5.cpp).
set(ISOLAW_HDF5_INCLUDE "")
if(NOT EMSCRIPTEN AND NOT WIN32)
  set(made ${from}/hdf5/made)
  list(PREPEND ISOLAW_WITHOUT_PACKAGE ${made}/bin/libhdf5_hl.a ${made}/bin/libhdf5.a bundled_zlib ${CMAKE_DL_LIBS})
  set(ISOLAW_HDF5_INCLUDE ${from}/hdf5/src ${from}/hdf5/hl/src ${made}/src)
endif()
set(ISOLAW_RANDOM123 ${from}/include)
include(plotly)
if(NOT EMSCRIPTEN)
  return()
endif()

# All sources are compiled and linked with these options. -msimd128 gives the portable kernels vectors of 128 bits
# (num/batch.hpp). -fwasm-exceptions uses WebAssembly's own exceptions, which cost no time unless one is thrown.
set(ISOLAW_PAGE_OPTIONS -fwasm-exceptions -msimd128)
add_compile_options(${ISOLAW_PAGE_OPTIONS} "$<$<COMPILE_LANGUAGE:CXX>:SHELL:-include ${PROJECT_SOURCE_DIR}/cmake/page/gaps.hpp>"
                    "$<$<COMPILE_LANGUAGE:CXX>:SHELL:-isystem ${from}/include>")
