// For assertions on what is said of wrong input.
#pragma once

#include <string>

#include "isolaw/base/error.hpp"

namespace isolaw {

// What `call` throws as an Error; empty where it throws none.
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
