#include "tables.hpp"

#include <cstring>

namespace isolaw::opensees {

void construct_base(Program const& program, Class const& of, Table const& table, std::byte* base, int tag) {
  constexpr int class_tag = 0;  // no number of OpenSees' own: it cannot make this object from one
  (program.calls().*of.constructor)(base, tag, class_tag);
  auto const point_to = [&](std::size_t at, std::size_t place) {
    auto const* const functions = table.data() + place;
    std::memcpy(base + at, &functions, sizeof(functions));
  };
  point_to(0, words_before_functions);
  point_to(movable_object_at, 2 * words_before_functions + of.functions.size());
}

int tag_of(void const* object) {
  int tag = 0;
  std::memcpy(&tag, static_cast<std::byte const*>(object) + sizeof(void*), sizeof(tag));
  return tag;
}

}  // namespace isolaw::opensees
