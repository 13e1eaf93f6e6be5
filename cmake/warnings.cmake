# Every target of the project links isolaw_warnings as PRIVATE, so that these options do not reach users of the library.
add_library(isolaw_warnings INTERFACE)
target_compile_options(isolaw_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wnon-virtual-dtor -Wold-style-cast
  -Woverloaded-virtual -Wnull-dereference -Wdouble-promotion
  $<$<BOOL:${ISOLAW_DEVELOPER}>:-Werror>)
# Sources that are compiled together (CMAKE_UNITY_BUILD) see each other's names, so only separate ones are checked for
# shadowing.
if(NOT CMAKE_UNITY_BUILD)
  target_compile_options(isolaw_warnings INTERFACE -Wshadow)
endif()
# The warning -Wrestrict of g++ 12 is wrong for joined strings (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(isolaw_warnings INTERFACE -Wno-restrict)
  # With -O3, g++ 12 also warns of null pointers and uninitialised values inside the standard library. With -O2 it does
  # not, so the developer preset keeps both warnings as errors.
  target_compile_options(isolaw_warnings INTERFACE
    $<$<CONFIG:Release>:-Wno-null-dereference> $<$<CONFIG:Release>:-Wno-maybe-uninitialized>)
endif()
# Without this option a compiler may fuse a product and a sum into one operation, which rounds differently. With it
# scalar code gives the same bits in every build type.
target_compile_options(isolaw_warnings INTERFACE -ffp-contract=off)
