# Writes the C++ source OUTPUT, which defines isolaw::MODULE::sources_hash: a hash of all sources that decide computed
# numbers. These sources are given as FOLDERS and FILES, relative to ROOT. Comments, white space and the place of the
# checkout do not change the hash.
# cmake -DROOT=... -DMODULE=... -DFOLDERS=a,b -DFILES=c,d -DOUTPUT=... -P sources_hash.cmake
set(names "")
string(REPLACE "," ";" FOLDERS "${FOLDERS}")
string(REPLACE "," ";" FILES "${FILES}")
foreach(folder IN LISTS FOLDERS)
  file(GLOB_RECURSE found RELATIVE ${ROOT} ${ROOT}/${folder}/*.hpp ${ROOT}/${folder}/*.cpp)
  list(APPEND names ${found})
endforeach()
list(APPEND names ${FILES})
list(SORT names)
set(hashes "")
foreach(name IN LISTS names)
  file(READ ${ROOT}/${name} text)
  string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  string(REGEX REPLACE "[ \t\r\n]+" "" text "${text}")
  string(SHA256 hash "${text}")
  string(APPEND hashes "${name} ${hash}\n")
endforeach()
string(SHA256 hash "${hashes}")
string(SUBSTRING ${hash} 0 12 hash)
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT
     "namespace isolaw::${MODULE} {\nextern char const* const sources_hash;\nchar const* const sources_hash = \"${hash}\";\n}\n")
