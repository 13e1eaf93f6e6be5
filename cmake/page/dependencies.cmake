# Defines the targets of cmake/dependencies.cmake for the page. tools/page_libraries.sh fetches the sources of the
# libraries, and this build compiles them to WebAssembly.
set(ISOLAW_PAGE_LIBRARIES ${PROJECT_BINARY_DIR}/libraries CACHE PATH "folder of tools/page_libraries.sh")
execute_process(COMMAND ${PROJECT_SOURCE_DIR}/tools/page_libraries.sh ${ISOLAW_PAGE_LIBRARIES} COMMAND_ERROR_IS_FATAL ANY)
set(from ${ISOLAW_PAGE_LIBRARIES})

add_library(page_headers INTERFACE)
target_include_directories(page_headers SYSTEM INTERFACE ${from}/include)
add_library(Boost::headers ALIAS page_headers)
add_library(CLI11::CLI11 ALIAS page_headers)
add_library(nlohmann_json::nlohmann_json ALIAS page_headers)
add_library(tomlplusplus::tomlplusplus ALIAS page_headers)
add_library(page_eigen INTERFACE)
target_include_directories(page_eigen SYSTEM INTERFACE ${from}/include/eigen3)
add_library(Eigen3::Eigen ALIAS page_eigen)
add_library(page_fmt INTERFACE)
target_link_libraries(page_fmt INTERFACE page_headers)
target_compile_definitions(page_fmt INTERFACE FMT_HEADER_ONLY)
add_library(fmt::fmt ALIAS page_fmt)
# The program has one thread in a browser, so the target for threads is empty.
add_library(page_threads INTERFACE)
add_library(Threads::Threads ALIAS page_threads)

# Builds a library from C sources that other projects wrote. This project does not change them, so compiler warnings are
# off.
function(page_library name)
  add_library(${name} STATIC ${ARGN})
  target_compile_options(${name} PRIVATE -O2 -w)
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
endfunction()

set(zlib adler32 compress crc32 deflate inffast inflate inftrees trees uncompr zutil)
list(TRANSFORM zlib REPLACE "(.+)" "${from}/zlib/\\1.c")
page_library(page_zlib ${zlib})
target_include_directories(page_zlib SYSTEM PUBLIC ${from}/zlib)
add_library(ZLIB::ZLIB ALIAS page_zlib)

page_library(page_minizip ${from}/minizip/ioapi.c ${from}/minizip/unzip.c)
target_compile_definitions(page_minizip PRIVATE USE_FILE32API NOUNCRYPT)
target_link_libraries(page_minizip PUBLIC page_zlib)
set(ISOLAW_WITHOUT_PACKAGE page_minizip)
set(ISOLAW_MINIZIP_INCLUDE ${from})

page_library(page_expat ${from}/expat/expat/lib/xmlparse.c ${from}/expat/expat/lib/xmlrole.c ${from}/expat/expat/lib/xmltok.c)
# The compile definitions below replace the header that expat's configure script would write.
file(WRITE ${PROJECT_BINARY_DIR}/made/expat_config.h "")
target_include_directories(page_expat PRIVATE ${PROJECT_BINARY_DIR}/made)
target_compile_definitions(page_expat PRIVATE XML_NS XML_DTD XML_GE=1 XML_CONTEXT_BYTES=1024 XML_DEV_URANDOM HAVE_MEMMOVE)
target_include_directories(page_expat SYSTEM PUBLIC ${from}/expat/expat/lib)
add_library(EXPAT::EXPAT ALIAS page_expat)

page_library(page_sqlite ${from}/sqlite3/made/sqlite3.c)
# SQLite needs no locks, because the page has one thread. It loads no extensions and maps no files into memory.
target_compile_definitions(page_sqlite PRIVATE SQLITE_THREADSAFE=0 SQLITE_OMIT_LOAD_EXTENSION SQLITE_MAX_MMAP_SIZE=0)
target_include_directories(page_sqlite SYSTEM PUBLIC ${from}/sqlite3/made)
add_library(SQLite::SQLite3 ALIAS page_sqlite)

# The program needs only SHA-256 from OpenSSL. Nettle has it in three small sources.
page_library(page_nettle ${from}/nettle/sha256.c ${from}/nettle/sha256-compress.c ${from}/nettle/write-be32.c)
target_include_directories(page_nettle SYSTEM PUBLIC ${from})
add_library(OpenSSL::Crypto ALIAS page_nettle)

# The page cannot read MATLAB files of version 7.3, so HDF5 is not needed (data/files/mat73_page.cpp).
set(ISOLAW_HDF5_INCLUDE "")
set(ISOLAW_RANDOM123 ${from}/include)
include(plotly)

# All sources are compiled and linked with these options. -msimd128 gives the portable kernels vectors of 128 bits
# (num/batch.hpp). -fwasm-exceptions uses WebAssembly's own exceptions, which cost no time unless one is thrown.
set(ISOLAW_PAGE_OPTIONS -fwasm-exceptions -msimd128)
add_compile_options(${ISOLAW_PAGE_OPTIONS} "$<$<COMPILE_LANGUAGE:CXX>:SHELL:-include ${PROJECT_SOURCE_DIR}/cmake/page/gaps.hpp>"
                    "$<$<COMPILE_LANGUAGE:CXX>:SHELL:-isystem ${from}/include>")
