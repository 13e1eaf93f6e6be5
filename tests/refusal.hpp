// Lets tests check the error messages that wrong input causes.
#pragma once

#include <string>

#include "isolaw/base/error.hpp"

namespace isolaw {

// The message of the Error that `call` throws; empty if it throws none.
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
