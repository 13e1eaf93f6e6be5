// The functions that Python calls through ctypes (isolaw/opensees.py). They return true on success. Otherwise they
// return false and write the reason into the caller's buffer of `size` bytes.
#include <algorithm>
#include <cstring>
#include <exception>
#include <map>
#include <memory>
#include <string>

#include "law.hpp"

namespace {

using isolaw::opensees::Program;

// A Program object for each OpenSees module that isolaw_attach() was given, by file name. The objects are never
// removed, because the materials that use them may live as long as the process.
std::map<std::string, std::unique_ptr<Program>>& programs() {
  static auto& all = *new std::map<std::string, std::unique_ptr<Program>>;
  return all;
}

template <class Work>
bool said(char* reason, std::size_t size, Work const& work) noexcept {
  auto const say = [&](char const* text) {
    std::size_t const length = std::min(std::strlen(text), size - 1);
    std::copy_n(text, length, reason);
    reason[length] = '\0';
    return false;
  };
  try {
    work();
    return true;
  } catch (std::exception const& error) {
    return say(error.what());
  } catch (...) {
    return say("an unknown error");
  }
}

}  // namespace

#define ISOLAW_EXPORTED __attribute__((visibility("default")))

extern "C" {

// Checks the OpenSees module in `file`. Later calls in this process with the same file do not check again.
ISOLAW_EXPORTED bool isolaw_attach(char const* file, char* reason, std::size_t size) {
  return said(reason, size, [&] {
    auto& program = programs()[file];
    if (!program) program = std::make_unique<Program>(file);
  });
}

ISOLAW_EXPORTED bool isolaw_material(char const* file, int tag, IsolawLaw const* law, char* reason, std::size_t size) {
  return said(reason, size, [&] { isolaw::opensees::add_material(*programs().at(file), tag, *law); });
}

ISOLAW_EXPORTED bool isolaw_section(char const* file, int tag, IsolawLaw const* law, char* reason, std::size_t size) {
  return said(reason, size, [&] { isolaw::opensees::add_section(*programs().at(file), tag, *law); });
}

}  // extern "C"
