// The programs for a browser and for Windows are built without the HDF5 library, so they cannot read files of MATLAB
// 7.3. Windows cannot fork a process, so the library could not be confined there (confined.hpp).
#include "isolaw/data/files/mat_file.hpp"

namespace isolaw::data {

std::unique_ptr<MatFile> open_mat73(std::string_view, std::string const& file) {
  throw Error({.where = file,
               .found = "a file of MATLAB 7.3, which isolaw reads neither in a browser nor on Windows",
               .allowed = "MATLAB files up to version 7, workbooks, text",
               .advice = "save it in MATLAB with save(..., '-v7'), or export time, displacement and force as CSV"});
}

}  // namespace isolaw::data
