// Makes objects of OpenSees' base classes, with virtual functions of this library in place of those of OpenSees.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "law.hpp"
#include "program.hpp"

namespace isolaw::opensees {

class TableWithOwn {  // a copy of a class's table of virtual functions, some of them replaced by this library's
 public:
  TableWithOwn(Program const& program, Class const& of) : class_(of), table_(program.table_of(of)) {}
  // own() puts a function of this library in place of the one with this name in Class::functions. own_as_movable() does
  // the same for a function of MovableObject.
  template <class Result, class... Arguments>
  void own(std::string_view name, Result (*function)(Arguments...)) {
    table_.at(place_of(class_, name)) = reinterpret_cast<Function>(function);
  }
  template <class Result, class... Arguments>
  void own(std::string_view name, Result (*function)(Arguments...) noexcept) {
    own(name, static_cast<Result (*)(Arguments...)>(function));
  }
  template <class Result, class... Arguments>
  void own_as_movable(std::string_view name, Result (*function)(Arguments...)) {
    table_.at(place_as_movable(class_, name)) = reinterpret_cast<Function>(function);
  }
  Table take() { return std::move(table_); }

 private:
  Class const& class_;
  Table table_;
};

// Calls OpenSees' constructor of the base class on `base`, the beginning of an object of this library, and makes
// `table` the object's table of virtual functions. `table` must live as long as the object.
void construct_base(Program const& program, Class const& of, Table const& table, std::byte* base, int tag);

inline constexpr int printed_as_json = 25000;  // OPS_PRINT_PRINTMODEL_JSON in OpenSees, a value of the flag of Print()

int tag_of(void const* object);  // the tag of an object that begins with a TaggedObject

// The numbers by which OpenSees asks for responses that only this library has. OpenSees' own responses have other
// numbers.
enum OwnResponse { energy_response = 4711, state_response };
// Makes a Response object, with which OpenSees asks `object` for this response at each step. The response always has as
// many numbers as `numbers`. Returns nullptr if there is no memory.
void* new_response(Program const& program, void* object, OwnResponse response, std::vector<double> numbers);
// Returns NaN, because laws have no derivatives with respect to parameters. The first call also tells the user so.
double no_sensitivity(Program const& program);
// Writes the numbers into an Information object of OpenSees.
int give(Program const& program, std::vector<double> numbers, void* information);

// Functions of this library that take the place of those of MovableObject. OpenSees calls them with the address of the
// MovableObject, which is a part of a larger object; whole() returns that object.
template <class Object>
struct AsMovable {
  static Object* whole(std::byte* movable) { return reinterpret_cast<Object*>(movable - movable_object_at); }
  static int refuse(std::byte* self) {
    complain(
        *whole(self)->program,
        "isolaw: OpenSees cannot make this object anew, in another process or from a database; create it there with "
        "isolaw.opensees, as here");
    return -1;
  }
  static int update(std::byte* self, int parameter, void* information) {
    auto& object = *whole(self);
    auto const value = object.program->value_in(information);
    double const factor = object.about->factor_of(static_cast<ParameterKind>(parameter), value);
    if (std::isfinite(factor) && factor > 0.0) {
      object.factor = factor;
      return 0;
    }
    complain(*object.program, std::isnan(factor)
                                  ? "isolaw: the law has no such bound, so its parameter cannot be set"
                                  : "isolaw: this value makes the factor on the force no finite number above 0");
    return -1;
  }
  static void put_into(TableWithOwn& table) {
    table.own_as_movable(
        "D1Ev", +[](std::byte* self) { destroy(whole(self)); });
    table.own_as_movable(
        "D0Ev", +[](std::byte* self) {
          destroy(whole(self));
          ::operator delete(whole(self));
        });
    table.own_as_movable(
        "12getClassTypeEv K", +[](std::byte*) { return "isolaw"; });
    table.own_as_movable(
        "8sendSelfEiR7Channel", +[](std::byte* self, int, void*) { return refuse(self); });
    table.own_as_movable(
        "8recvSelfEiR7ChannelR16FEM_ObjectBroker", +[](std::byte* self, int, void*, void*) { return refuse(self); });
    table.own_as_movable(
        "12setParameterEPPKciR9Parameter", +[](std::byte* self, char const** words, int count, void* parameter) {
          auto const& object = *whole(self);
          return set_parameter(*object.program, *object.about, object.factor, self, words, count, parameter);
        });
    table.own_as_movable("15updateParameterEiR11Information", &update);
  }
};

}  // namespace isolaw::opensees
