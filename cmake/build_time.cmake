# Settings that keep the build short. The presets also join a folder's sources (CMAKE_UNITY_BUILD), so that names in the
# unnamed namespaces of one folder must differ. The developer preset compiles each source alone: an edit costs only that
# source, and a forgotten include shows.

# Precompiled headers: those that nearly every source includes. Not the JSON and TOML libraries, whose templates would cost
# every source more than they save the few that need them.
set(ISOLAW_READ_EVERYWHERE <algorithm> <array> <cmath> <filesystem> <functional> <limits> <map> <memory> <optional> <span>
  <string> <string_view> <utility> <vector> <fmt/format.h>)

# Code that only calls the numerics needs little run time, and -O1 compiles it in a third less time.
set(ISOLAW_CALLING_OPTIONS $<$<CONFIG:Release>:-O1> CACHE STRING "Compiler options of the code outside the numerics")
