// The OpenSees program that runs in this process: its functions, found by name, and the proof that its classes have the
// layout that this library relies on.
//
// OpenSees has no interface for materials that come from outside. A module of it exports its classes, though, and the
// Itanium C++ ABI (https://itanium-cxx-abi.github.io/cxx-abi/abi.html) says how the compiler lays them out. isolaw
// makes an object of a base class by the program's own constructor and gives it a copy of the base class's table of
// virtual functions in which some functions are isolaw's. Nothing of that is assumed: `attach` compares every entry of
// every table with the function that it must be, by its exported name, and the size and layout of every object with
// what the program's constructors write. Where anything differs it throws Error, and nothing has been changed.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isolaw::opensees {

using Function = void (*)();

// A table of virtual functions as it lies in memory: the functions of the class, then those of its base MovableObject.
// Each part begins with two words, the way back to the whole object and the type, before the first function.
inline constexpr std::size_t words_before_functions = 2;
using Table = std::vector<Function>;

inline constexpr std::size_t movable_object_at = 16;  // bytes from an object to its part that is a MovableObject

struct Vector;

// The functions of the program that isolaw calls once it is proved, and the variables that it reads.
struct Calls {
  void (*begin_material)(void* object, int tag, int class_tag);  // constructors and destructors of the base classes
  void (*begin_section)(void* object, int tag, int class_tag);
  void (*end_material)(void* object);
  void (*end_section)(void* object);
  bool (*add_material)(void* object);  // false if the tag exists
  bool (*add_section)(void* object);
  void (*begin_vector)(void* object, double* numbers, int size);
  void (*begin_matrix)(void* object, double* numbers, int rows, int columns);
  void (*begin_id)(void* object, int* numbers, int size, bool owns);
  void (*begin_response)(void* object, void* material, int response, Vector const* numbers);
  int (*set_numbers)(void* information, Vector const* numbers);
  void* (*set_response)(void* material, char const* const* words, int count, void* stream);  // of UniaxialMaterial
  int (*get_response)(void* material, int response, void* information);
  void* (*set_section_response)(void* section, char const* const* words, int count, void* stream);
  int (*get_section_response)(void* section, int response, void* information);
  void (*set_parameter_value)(void* parameter, double value);
  int (*add_to_parameter)(void* parameter, int which, void* movable);
  void** (*nodes_of)(void* zero_length_section);
  Vector const* (*displacement_of)(void* node);
  Vector const* (*velocity_of)(void* node);
  double const* time_step;
  void* const* active_element;
  void* const* errors;                  // the stream of errors
  Function const* zero_length_section;  // the class's table
};

// The virtual functions of a base class, in their order. A name is what the compiler writes after the name of the
// class: "9getStrainEv" for getStrain(). A name that ends with 'K' and a space before it belongs to a const function.
struct Class {
  std::string_view name, ready;  // the base class, and a class of the program that derives from it
  void (*Calls::*constructor)(void* object, int tag, int class_tag);  // of the base class
  std::size_t bytes;                                                  // the size of the base class
  std::span<std::string_view const> functions;  // of the class itself; those of MovableObject follow in its table
};
extern Class const uniaxial_material, section_force_deformation;

class Program {
 public:
  // Throws Error if `file` is no module that is loaded in this process, or if it is not laid out as expected.
  explicit Program(std::string const& file);

  Calls const& calls() const { return calls_; }
  // A copy of the class's table in which functions of the program can be replaced.
  Table table_of(Class const& of) const;
  void write(void* stream, std::string const& text) const;  // to an OPS_Stream of the program
  double value_in(void const* information) const;           // the number in an Information

  // The motion of one end of the element under way against the other, in global coordinates; nothing if there is none or
  // it is no ZeroLengthSection.
  struct Motion {
    std::array<double, 3> displacement{}, velocity{};
  };
  std::optional<Motion> motion_of_active_element() const;

 private:
  // The program's function or object of this name, as the compiler writes it. symbol() throws Error if there is none.
  void* symbol(std::string const& name) const;
  void* symbol_or_null(std::string const& name) const;
  void find_calls();
  void prove(Class const& of) const;
  void prove_values() const;
  void rehearse() const;
  void find_members();

  std::string file_;
  void* handle_ = nullptr;
  Calls calls_ = {};
  std::size_t text_to_stream_ = 0;        // place of operator<< for text in the table of a stream
  std::size_t value_in_information_ = 0;  // bytes from an Information to its number
};

// Places in a table of the class: of one of its own functions (a name of Class::functions), and of a function of
// MovableObject as it is called by those who know the object as one.
std::size_t place_of(Class const& of, std::string_view name);
std::size_t place_as_movable(Class const& of, std::string_view name);

// Writes a sentence to the program's stream of errors.
void complain(Program const& program, std::string const& sentence);

}  // namespace isolaw::opensees
