// Lets tests check the error messages that wrong input causes.
#pragma once

#include <string>

#include "isolaw/base/error.hpp"

namespace isolaw {

// Returns the message of the Error that `call` throws, or an empty text if `call` throws none.
template <class Call>
std::string refusal_of(Call&& call) {
  try {
    call();
  } catch (Error const& error) {
    return error.what();
  }
  return {};
}

}  // namespace isolaw
