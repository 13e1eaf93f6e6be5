// Helps to make an object of a base class of the program with functions of this library.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "law.hpp"
#include "program.hpp"

namespace isolaw::opensees {

class TableWithOwn {
 public:
  TableWithOwn(Program const& program, Class const& of) : class_(of), table_(program.table_of(of)) {}
  // Replaces the function of this name, as in Class::functions, or one of MovableObject.
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

// Makes the part of an object that is the program's, and gives it `table`, which must live as long as the object.
void construct_base(Program const& program, Class const& of, Table const& table, std::byte* base, int tag);

inline constexpr int printed_as_json = 25000;  // flag of Print() in OpenSees: OPS_PRINT_PRINTMODEL_JSON

int tag_of(void const* object);  // of a TaggedObject

// Numbers of the responses of this library, which the program does not use itself.
enum OwnResponse { energy_response = 4711, state_response };
// A new Response of the program, with which it asks `object` for as many numbers each time. Null if there is no memory.
void* new_response(Program const& program, void* object, OwnResponse response, std::vector<double> numbers);
double no_sensitivity(Program const& program);  // says once that there is none, and returns not a number
int give(Program const& program, std::vector<double> numbers, void* information);

// The functions of MovableObject for an object of this library, which get the address of that part of the object.
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
