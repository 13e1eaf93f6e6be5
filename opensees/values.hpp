// Makes objects of the OpenSees classes Vector, Matrix and ID that use arrays of this library. The constructors of
// OpenSees make them. They own no memory, so they need no destructor.
#pragma once

#include <cstddef>

#include "program.hpp"

namespace isolaw::opensees {

// The layout of these classes, as far as this library reads their members. Program::prove_values() checks it.
struct Vector {
  using Number = double;
  int size;
  double* numbers;
};
struct Id {
  using Number = int;
  int size;
  int* numbers;
};
struct Matrix {  // two rows and columns, column after column
  using Number = double;
};

template <class Value>
class ValuesOf {
 public:
  ValuesOf(Program const& program, typename Value::Number* numbers, int size = 2);
  ValuesOf(ValuesOf const&) = delete;
  ValuesOf& operator=(ValuesOf const&) = delete;
  Value& get() const { return *reinterpret_cast<Value*>(const_cast<std::byte*>(memory_)); }

 private:
  static constexpr std::size_t more_than_it_needs = 64;
  alignas(16) std::byte memory_[more_than_it_needs] = {};
};

template <>
inline ValuesOf<Vector>::ValuesOf(Program const& program, double* numbers, int size) {
  program.calls().begin_vector(memory_, numbers, size);
}
template <>
inline ValuesOf<Matrix>::ValuesOf(Program const& program, double* numbers, int size) {
  program.calls().begin_matrix(memory_, numbers, size, size);
}
template <>
inline ValuesOf<Id>::ValuesOf(Program const& program, int* numbers, int size) {
  program.calls().begin_id(memory_, numbers, size, false);
}

}  // namespace isolaw::opensees
