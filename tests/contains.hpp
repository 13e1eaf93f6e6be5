// Offers a function with which tests check that a text contains a part.
#pragma once

#include <string>

namespace isolaw {

inline bool contains(std::string const& text, std::string const& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace isolaw
