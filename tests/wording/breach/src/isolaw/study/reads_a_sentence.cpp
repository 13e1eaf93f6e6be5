// The deliberate error that searched.py must find: code that decides by the words of a warning.
#include <string>

bool is_about_cycles(std::string const& warning) {
  return warning.starts_with("no cyclic properties");
}
