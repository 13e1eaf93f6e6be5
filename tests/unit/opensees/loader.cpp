// A library that OpenSees loads. It adds a Tcl command that makes a material of another library by OpenSees' own search
// and parser. OpenSees' command uniaxialMaterial does this too, but first runs code that a partial build of OpenSees
// may lack.
#include <cstring>
#include <string>

struct Tcl_Interp;
class Domain;
class UniaxialMaterial;
extern Domain* ops_TheActiveDomain;
int getLibraryFunction(char const* library, char const* function, void** library_handle, void** function_handle);
bool OPS_addUniaxialMaterial(UniaxialMaterial* material);
extern "C" {
int OPS_ResetInputNoBuilder(void* data, Tcl_Interp* interpreter, int first, int count, char const** words,
                            Domain* domain);
void* Tcl_CreateCommand(Tcl_Interp* interpreter, char const* name,
                        int (*command)(void*, Tcl_Interp*, int, char const**), void* data, void* deleted);

static int loaded_material(void* data, Tcl_Interp* interpreter, int count, char const** words) {
  void *library = nullptr, *function = nullptr;
  if (count < 3 || getLibraryFunction(words[1], (std::string("OPS_") + words[1]).c_str(), &library, &function) != 0)
    return 1;
  OPS_ResetInputNoBuilder(data, interpreter, 2, count, words, ops_TheActiveDomain);
  void* (*parse)() = nullptr;
  std::memcpy(&parse, &function, sizeof(parse));
  auto* const material = static_cast<UniaxialMaterial*>(parse());
  return material != nullptr && OPS_addUniaxialMaterial(material) ? 0 : 1;
}

int Loader_Init(Tcl_Interp* interpreter) {
  Tcl_CreateCommand(interpreter, "loadedMaterial", loaded_material, nullptr, nullptr);
  return 0;
}
}
