# Compiles for Windows with Debian's mingw-w64 (g++-mingw-w64-x86-64-posix). The program is linked statically, so that it
# needs only libraries of the system.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_FIND_ROOT_PATH /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
# GCC does not align vectors of 32 and 64 bytes on the stack of Windows (bug 54412), so the assembler replaces the moves
# that need aligned memory.
set(CMAKE_CXX_FLAGS_INIT "-Wa,-muse-unaligned-vector-move -include ${CMAKE_CURRENT_LIST_DIR}/windows/gaps.hpp")
