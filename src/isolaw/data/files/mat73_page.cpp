// In the browser isolaw cannot read files of MATLAB 7.3, because the page does not contain the HDF5 library.
#include "isolaw/data/files/mat_file.hpp"

namespace isolaw::data {

std::unique_ptr<MatFile> open_mat73(std::string_view, std::string const& file) {
  throw Error({.where = file,
               .found = "a file of MATLAB 7.3, which the program in a browser does not read",
               .allowed = "MATLAB files up to version 7, workbooks, text",
               .advice = "save it in MATLAB with save(..., '-v7'), or export time, displacement and force as CSV"});
}

}  // namespace isolaw::data
