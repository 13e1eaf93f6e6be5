// Finds the functions of the OpenSees that runs in this process, and checks that its classes have the layout that this
// library relies on.
//
// OpenSees has no interface for materials from other libraries. But its Python module exports its classes, and the
// Itanium C++ ABI (https://itanium-cxx-abi.github.io/cxx-abi/abi.html) says how the compiler lays them out. To make a
// material, isolaw calls OpenSees' own constructor of the base class. It then lets the object point to a copy of the
// base class's table of virtual functions, in which isolaw's functions replace some of those of OpenSees. The
// constructor of Program checks everything on which this method relies before anything is changed. It compares each
// entry of each table with the address of the function that must stand there, found by its exported name. It also
// compares the size and layout of objects with what the constructors of OpenSees write. It throws Error if anything
// differs.
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

// A table of virtual functions as it lies in memory. Its first part has the functions of the class, its second part
// those of the base class MovableObject. Two words stand before the functions of each part: the offset from this part
// of an object to the whole object, and the address of the type information.
inline constexpr std::size_t words_before_functions = 2;
using Table = std::vector<Function>;

inline constexpr std::size_t movable_object_at = 16;  // bytes from an object to its part that is a MovableObject

struct Vector;

// The functions of OpenSees that isolaw calls after the check, and the variables of OpenSees that it reads.
struct Calls {
  // begin_... are constructors, end_... are destructors.
  void (*begin_material)(void* object, int tag, int class_tag);
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
  void* (*set_response)(void* material, char const* const* words, int count, void* stream);
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
  void* const* errors;                  // the stream for error messages
  Function const* zero_length_section;  // the table of virtual functions of ZeroLengthSection
};

// A base class and its virtual functions, in the order of its table. Functions have the name that the compiler writes
// after the name of the class: "9getStrainEv" for getStrain(). " K" at the end marks a const function.
struct Class {
  std::string_view name, ready;  // the base class, and a class of OpenSees derived from it, which the check uses
  void (*Calls::*constructor)(void* object, int tag, int class_tag);  // constructor of the base class
  std::size_t bytes;                                                  // the size of the base class
  std::span<std::string_view const> functions;  // without the functions of MovableObject, which follow in the table
};
extern Class const uniaxial_material, section_force_deformation;

class Program {
 public:
  // `file` is the module of OpenSees. Throws Error if this process has not loaded it, or if the check fails.
  explicit Program(std::string const& file);

  Calls const& calls() const { return calls_; }
  // A copy of the class's table of virtual functions. The caller may replace functions in it.
  Table table_of(Class const& of) const;
  void write(void* stream, std::string const& text) const;  // to an OPS_Stream of OpenSees
  double value_in(void const* information) const;           // returns the number that an Information object holds

  // The motion of the second node of the active element (the one that OpenSees is computing) relative to the first, in
  // global coordinates. nullopt if no element is active or if it is no ZeroLengthSection.
  struct Motion {
    std::array<double, 3> displacement{}, velocity{};
  };
  std::optional<Motion> motion_of_active_element() const;

 private:
  // The address of the OpenSees function or variable with this mangled name. If there is none, symbol() throws Error
  // and symbol_or_null() returns nullptr.
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
  std::size_t text_to_stream_ = 0;        // index of operator<<(char const*) among the virtual functions of a stream
  std::size_t value_in_information_ = 0;  // bytes from an Information to its number
};

// The index of a function in the table of the class. place_of() looks for a name of Class::functions in the first part
// of the table. place_as_movable() looks for a function of MovableObject in the second part, which is used by callers
// that have a pointer to the MovableObject.
std::size_t place_of(Class const& of, std::string_view name);
std::size_t place_as_movable(Class const& of, std::string_view name);

// Writes a sentence to the stream of OpenSees for error messages.
void complain(Program const& program, std::string const& sentence);

}  // namespace isolaw::opensees
