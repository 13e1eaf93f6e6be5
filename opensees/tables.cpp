#include "tables.hpp"

#include <cstring>
#include <limits>
#include <new>

#include "values.hpp"

namespace isolaw::opensees {

void construct_base(Program const& program, Class const& of, Table const& table, std::byte* base, int tag) {
  constexpr int class_tag = 0;  // no OpenSees class has this number, so OpenSees never tries to copy the object by it
  (program.calls().*of.constructor)(base, tag, class_tag);
  auto const point_to = [&](std::size_t at, std::size_t place) {
    auto const* const functions = table.data() + place;
    std::memcpy(base + at, &functions, sizeof(functions));
  };
  point_to(0, words_before_functions);
  point_to(movable_object_at, 2 * words_before_functions + of.functions.size());
}

void* new_response(Program const& program, void* object, OwnResponse response, std::vector<double> numbers) {
  constexpr std::size_t more_than_it_needs = 1024;
  void* const made = ::operator new(more_than_it_needs, std::nothrow);
  ValuesOf<Vector> const vector(program, numbers.data(), static_cast<int>(numbers.size()));
  if (made != nullptr) program.calls().begin_response(made, object, response, &vector.get());
  return made;
}

int give(Program const& program, std::vector<double> numbers, void* information) {
  ValuesOf<Vector> const vector(program, numbers.data(), static_cast<int>(numbers.size()));
  return program.calls().set_numbers(information, &vector.get());
}

double no_sensitivity(Program const& program) {
  static bool const said =
      (complain(program, "isolaw: the laws give no derivatives by parameters (sensitivity)"), true);
  static_cast<void>(said);
  return std::numeric_limits<double>::quiet_NaN();
}

int tag_of(void const* object) {
  int tag = 0;
  std::memcpy(&tag, static_cast<std::byte const*>(object) + sizeof(void*), sizeof(tag));
  return tag;
}

}  // namespace isolaw::opensees
