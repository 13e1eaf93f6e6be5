// Makes a std::filesystem::path from a text in UTF-8 on Windows. libstdc++ returns UTF-8 from path::string(). But when
// it makes a path from a text, it takes each byte for a character. The compiler option -include puts this file before
// every source.
#pragma once

#ifdef __cplusplus

#include <filesystem>

template <>
inline auto std::filesystem::path::_S_convert<char>(char const* first, char const* last) {
  return __detail::__wstr_from_utf8(std::string_view(first, static_cast<std::size_t>(last - first)));
}

#endif
