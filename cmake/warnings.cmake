# Every target of the project links isolaw_warnings privately.
add_library(isolaw_warnings INTERFACE)
target_compile_options(isolaw_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor -Wold-style-cast
  -Woverloaded-virtual -Wnull-dereference -Wdouble-promotion
  $<$<BOOL:${ISOLAW_DEVELOPER}>:-Werror>)
# g++ 12 warns of overlapping copies in string concatenations where there are none (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(isolaw_warnings INTERFACE -Wno-restrict)
  # At -O1 and -O3 it warns of null pointers and uninitialised values in the standard library. At -O2 it does not, so
  # both warnings remain errors in the developer preset.
  target_compile_options(isolaw_warnings INTERFACE
    $<$<CONFIG:Release>:-Wno-null-dereference> $<$<CONFIG:Release>:-Wno-maybe-uninitialized>)
endif()
# The scalar path must give the same bits in every build type, so products and sums are not fused.
target_compile_options(isolaw_warnings INTERFACE -ffp-contract=off)
