# These settings keep the build short. The presets (except `developer`) also compile all sources of a folder as one unit
# (CMAKE_UNITY_BUILD). Names in the unnamed namespaces of one folder must therefore differ. The developer preset
# compiles each source alone, so that an edit compiles only that source again and a forgotten #include is an error.

# Nearly every source includes these headers, so they are precompiled. The headers of the JSON and TOML libraries are
# not among them: their templates would slow down every source more than they would speed up the few sources that
# include them.
set(ISOLAW_READ_EVERYWHERE <algorithm> <array> <cmath> <filesystem> <functional> <limits> <map> <memory> <optional> <span>
  <string> <string_view> <utility> <vector> <fmt/format.h>)

# Code outside the numerics takes little of a run's time. Compiling it with -O1 instead of -O3 shortens the build by a
# third.
set(ISOLAW_CALLING_OPTIONS $<$<CONFIG:Release>:-O1> CACHE STRING "Compiler options of the code outside the numerics")
