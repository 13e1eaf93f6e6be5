#include "program.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#ifdef __linux__
#include <link.h>
#endif

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>

#include "isolaw/base/error.hpp"
#include "values.hpp"

namespace isolaw::opensees {
namespace {

constexpr std::string_view uniaxial_functions[]{"D1Ev",
                                                "D0Ev",
                                                "5PrintER10OPS_Streami",
                                                "11setResponseEPPKciR10OPS_Stream",
                                                "11getResponseEiR11Information",
                                                "22getResponseSensitivityEiiR11Information",
                                                "6updateEv",
                                                "14setTrialStrainEdd",
                                                "14setTrialStrainEddd",
                                                "8setTrialEdRdS0_d",
                                                "8setTrialEddRdS0_S0_d",
                                                "9getStrainEv",
                                                "13getStrainRateEv",
                                                "9getStressEv",
                                                "10getTangentEv",
                                                "17getInitialTangentEv",
                                                "14getDampTangentEv",
                                                "6getRhoEv",
                                                "11commitStateEv",
                                                "18revertToLastCommitEv",
                                                "13revertToStartEv",
                                                "7getCopyEv",
                                                "7getCopyEP23SectionForceDeformation",
                                                "9hasFailedEv",
                                                "20getStressSensitivityEib",
                                                "20getStrainSensitivityEi",
                                                "21getTangentSensitivityEi",
                                                "28getInitialTangentSensitivityEi",
                                                "25getDampTangentSensitivityEi",
                                                "17getRhoSensitivityEi",
                                                "17commitSensitivityEdii",
                                                "9getEnergyEv"};

constexpr std::string_view section_functions[]{"D1Ev",
                                               "D0Ev",
                                               "5PrintER10OPS_Streami",
                                               "11setResponseEPPKciR10OPS_Stream",
                                               "11getResponseEiR11Information",
                                               "22getResponseSensitivityEiiR11Information",
                                               "6updateEv",
                                               "26setTrialSectionDeformationERK6Vector",
                                               "21getSectionDeformationEv",
                                               "18getStressResultantEv",
                                               "17getSectionTangentEv",
                                               "17getInitialTangentEv",
                                               "21getSectionFlexibilityEv",
                                               "21getInitialFlexibilityEv",
                                               "6getRhoEv",
                                               "11commitStateEv",
                                               "18revertToLastCommitEv",
                                               "13revertToStartEv",
                                               "7getCopyEv",
                                               "7getTypeEv",
                                               "8getOrderEv K",
                                               "29getStressResultantSensitivityEib",
                                               "32getSectionDeformationSensitivityEi",
                                               "28getSectionTangentSensitivityEi",
                                               "32getSectionFlexibilitySensitivityEi",
                                               "28getInitialTangentSensitivityEi",
                                               "32getInitialFlexibilitySensitivityEi",
                                               "17getRhoSensitivityEi",
                                               "17commitSensitivityERK6Vectorii",
                                               "26setTrialSectionDeformationERK6VectorS2_",
                                               "20getTemperatureStressERK6Vector",
                                               "15getThermalElongEv",
                                               "9getEnergyEv K"};

constexpr std::string_view movable_functions[]{"D1Ev",
                                               "D0Ev",
                                               "12getClassTypeEv K",
                                               "8sendSelfEiR7Channel",
                                               "8recvSelfEiR7ChannelR16FEM_ObjectBroker",
                                               "12setParameterEPPKciR9Parameter",
                                               "15updateParameterEiR11Information",
                                               "17activateParameterEi",
                                               "11setVariableEPKcR11Information",
                                               "11getVariableEPKcR11Information"};

// Returns the mangled name of a member function: "_ZN" or, for a const function, "_ZNK", then the length and name of
// the class, then the function as it is written in Class::functions. Example: "_ZN16UniaxialMaterial9getStressEv".
std::string mangled(std::string_view class_name, std::string_view function) {
  bool const is_const = function.ends_with(" K");
  if (is_const) function.remove_suffix(2);
  return fmt::format("_ZN{}{}{}{}", is_const ? "K" : "", class_name.size(), class_name, function);
}
// Returns the mangled name of the thunk of a member function. A caller that has a pointer to the MovableObject within
// the object calls the function through this thunk.
std::string thunk(std::string_view class_name, std::string_view function) {
  auto const name = mangled(class_name, function);
  return fmt::format("_ZThn{}_{}", movable_object_at, name.substr(2));
}
std::string table_name(std::string_view class_name) {
  return fmt::format("_ZTV{}{}", class_name.size(), class_name);
}
std::string type_name(std::string_view class_name) {
  return fmt::format("_ZTI{}{}", class_name.size(), class_name);
}

[[noreturn]] void differ(std::string found) {
  throw Error({.where = "this OpenSees",
               .found = std::move(found),
               .allowed = "a program with the classes of OpenSees 3.2 to 3.8",
               .advice = "isolaw export --to openseespy (a re-fitted material) or --to opensees-cpp (to compile)"});
}

void expect(bool holds, std::string_view what) {
  if (!holds) differ(std::string(what));
}

// The layout of std::type_info in the Itanium C++ ABI, for a class with one base and for a class with several bases.
struct OneBaseType {
  void* table;
  char const* name;
  void* base;
};
struct TypeWithBases {
  void* table;
  char const* name;
  unsigned flags, count;
  struct Base {
    void* type;
    long offset_and_flags;
  } bases[2];
};

// Says for each of `most` bytes whether a constructor writes it. The constructor runs twice, on memory that was filled
// with two different values. It wrote those bytes that are equal afterwards.
template <class Construct>
std::vector<bool> written_bytes(std::size_t most, Construct construct) {
  std::vector<unsigned char> memory[2];
  unsigned char const fillings[]{0xA5, 0x5A};
  for (std::size_t k = 0; k < 2; ++k) {
    // The memory is aligned for every type, because std::vector takes it from operator new.
    memory[k].assign(most, fillings[k]);
    construct(static_cast<void*>(memory[k].data()));
  }
  std::vector<bool> written(most);
  for (std::size_t i = 0; i < most; ++i) written[i] = memory[0][i] == memory[1][i];
  return written;
}

}  // namespace

Class const uniaxial_material{"UniaxialMaterial", "ElasticMaterial", &Calls::begin_material, 32, uniaxial_functions};
Class const section_force_deformation{"SectionForceDeformation", "Bidirectional", &Calls::begin_section, 48,
                                      section_functions};

std::size_t place_of(Class const& of, std::string_view name) {
  auto const found = std::ranges::find(of.functions, name);
  return words_before_functions + static_cast<std::size_t>(found - of.functions.begin());
}

std::size_t place_as_movable(Class const& of, std::string_view name) {
  auto const found = std::ranges::find(movable_functions, name);
  return 2 * words_before_functions + of.functions.size() +
         static_cast<std::size_t>(found - std::begin(movable_functions));
}

Program::Program(std::string const& file) : file_(file) {
  handle_ = dlopen(file.c_str(), RTLD_NOW | RTLD_NOLOAD | RTLD_LOCAL);
  if (handle_ == nullptr)
    throw Error({.where = file,
                 .found = "not loaded in this process",
                 .allowed = "the module that Python has imported as openseespy.opensees"});
  find_calls();
  prove(uniaxial_material);
  prove(section_force_deformation);
  prove_values();
  rehearse();
  find_members();
}

void* Program::symbol_or_null(std::string const& name) const {
  return dlsym(handle_, name.c_str());
}

void* Program::symbol(std::string const& name) const {
  void* const found = symbol_or_null(name);
  if (found == nullptr) differ(fmt::format("it exports no {}", name));
  return found;
}

void Program::find_calls() {
  auto const find = [this]<class T>(T*& call, std::string const& name) { call = reinterpret_cast<T*>(symbol(name)); };
  find(calls_.begin_material, "_ZN16UniaxialMaterialC2Eii");
  find(calls_.begin_section, "_ZN23SectionForceDeformationC2Eii");
  find(calls_.end_material, "_ZN16UniaxialMaterialD2Ev");
  find(calls_.end_section, "_ZN23SectionForceDeformationD2Ev");
  find(calls_.add_material, "_Z23OPS_addUniaxialMaterialP16UniaxialMaterial");
  find(calls_.add_section, "_Z30OPS_addSectionForceDeformationP23SectionForceDeformation");
  find(calls_.begin_vector, "_ZN6VectorC1EPdi");
  find(calls_.begin_matrix, "_ZN6MatrixC1EPdii");
  find(calls_.begin_id, "_ZN2IDC1EPiib");
  find(calls_.begin_response, "_ZN16MaterialResponseC1EP8MaterialiRK6Vector");
  find(calls_.set_numbers, "_ZN11Information9setVectorERK6Vector");
  find(calls_.set_response, "_ZN16UniaxialMaterial11setResponseEPPKciR10OPS_Stream");
  find(calls_.get_response, "_ZN16UniaxialMaterial11getResponseEiR11Information");
  find(calls_.set_section_response, "_ZN23SectionForceDeformation11setResponseEPPKciR10OPS_Stream");
  find(calls_.get_section_response, "_ZN23SectionForceDeformation11getResponseEiR11Information");
  find(calls_.set_parameter_value, "_ZN9Parameter8setValueEd");
  find(calls_.add_to_parameter, "_ZN9Parameter9addObjectEiP13MovableObject");
  find(calls_.nodes_of, "_ZN17ZeroLengthSection11getNodePtrsEv");
  find(calls_.displacement_of, "_ZN4Node12getTrialDispEv");
  find(calls_.velocity_of, "_ZN4Node11getTrialVelEv");
  find(calls_.time_step, "ops_Dt");
  find(calls_.active_element, "ops_TheActiveElement");
  find(calls_.errors, "opserrPtr");
  find(calls_.zero_length_section, table_name("ZeroLengthSection"));
}

Table Program::table_of(Class const& of) const {
  auto const* const words = static_cast<Function const*>(symbol(table_name(of.name)));
  return {words, words + 2 * words_before_functions + of.functions.size() + std::size(movable_functions)};
}

void Program::prove(Class const& of) const {
  auto const name = std::string(of.name);
  auto const word = [](void const* pointer) { return reinterpret_cast<std::uintptr_t>(pointer); };

  // Checks that the class derives from Material alone, and Material from TaggedObject and, 16 bytes into the object,
  // from MovableObject.
  auto const* const type = static_cast<OneBaseType const*>(symbol(type_name(of.name)));
  auto const* const material = static_cast<TypeWithBases const*>(symbol(type_name("Material")));
  constexpr long is_public = 2, offset_shift = 8;
  expect(type->base == material, name + " does not derive from Material alone");
  expect(material->count == 2 && material->bases[0].type == symbol(type_name("TaggedObject")) &&
             material->bases[0].offset_and_flags == is_public &&
             material->bases[1].type == symbol(type_name("MovableObject")) &&
             material->bases[1].offset_and_flags == ((long{movable_object_at} << offset_shift) | is_public),
         "Material does not consist of TaggedObject and, 16 bytes on, MovableObject");

  // Checks the tables of virtual functions of the base class and of `of.ready`, a class of OpenSees that derives from
  // it.
  auto const table = table_of(of);
  auto const* const base_words = static_cast<std::uintptr_t const*>(symbol(table_name(of.name)));
  auto const* const ready_words = static_cast<std::uintptr_t const*>(symbol(table_name(of.ready)));
#ifdef __linux__
  Dl_info found;
  ElfW(Sym)* entry = nullptr;
  bool const is_known = dladdr1(base_words, &found, reinterpret_cast<void**>(&entry), RTLD_DL_SYMENT) != 0;
  expect(is_known && entry != nullptr && entry->st_size == table.size() * sizeof(Function),
         fmt::format("{} has {} words in its table of virtual functions instead of {}", name,
                     entry == nullptr ? 0 : entry->st_size / sizeof(Function), table.size()));
#endif
  void* const missing = symbol("__cxa_pure_virtual");
  auto const is_one_of = [&](std::uintptr_t function, std::initializer_list<std::string> names) {
    return std::ranges::any_of(names, [&](auto const& each) {
      void* const there = symbol_or_null(each);
      return there != nullptr && word(there) == function;
    });
  };
  auto const part = [&](std::uintptr_t const* base, std::uintptr_t const* ready, std::uintptr_t offset,
                        std::span<std::string_view const> functions, bool is_movable) {
    expect(base[0] == offset && ready[0] == offset, name + ": a part of it begins at another place");
    expect(base[1] == word(type) && ready[1] == word(symbol(type_name(of.ready))),
           name + ": its table has another type");
    for (std::size_t i = 0; i < functions.size(); ++i) {
      auto const& function = functions[i];
      auto const in_base = base[words_before_functions + i], in_ready = ready[words_before_functions + i];
      bool const is_destructor = i < 2;
      auto const owner = is_movable ? std::string_view("MovableObject") : std::string_view("Material");
      bool const base_good =
          in_base == 0 || in_base == word(missing) ||
          is_one_of(in_base, {mangled(of.name, function), mangled(owner, function), thunk(of.name, function)});
      bool const ready_good = is_movable ? is_one_of(in_ready, {thunk(of.ready, function), mangled(owner, function)})
                                         : is_one_of(in_ready, {mangled(of.ready, function), mangled(of.name, function),
                                                                mangled(owner, function)});
      expect(base_good && ready_good && (in_base != 0 || is_destructor),
             fmt::format("{}: another function stands where {} should be", name, function));
    }
  };
  part(base_words, ready_words, 0, of.functions, false);
  // If `of.ready` overrides functions of MovableObject, the first part of its table has these functions too and is
  // longer than in the table of the base class. Its second part begins at the word with the offset of the
  // MovableObject.
  auto const second = words_before_functions + of.functions.size();
  auto const at = static_cast<std::uintptr_t>(-static_cast<std::intptr_t>(movable_object_at));
  std::size_t later = second;
  while (later < second + std::size(movable_functions) && ready_words[later] != at) ++later;
  part(base_words + second, ready_words + later, at, movable_functions, true);

  // The last byte that the constructor writes gives the size of an object, up to padding.
  auto const construct = calls_.*of.constructor;
  auto const written = written_bytes(8 * of.bytes, [&](void* memory) { construct(memory, 7, 9); });
  auto const last = std::find(written.rbegin(), written.rend(), true);
  auto const bytes = static_cast<std::size_t>(written.rend() - last);
  expect(bytes <= of.bytes && bytes + sizeof(void*) > of.bytes,
         fmt::format("an object of {} has {} bytes instead of {}", name, bytes, of.bytes));
}

void Program::prove_values() const {
  // Makes a Vector, a Matrix and an ID that use the arrays of this function, reads their members, and lets OpenSees
  // multiply the matrix by the vector.
  double numbers[]{1.0, 3.0, 2.0, 4.0}, two[]{10.0, 100.0}, product[]{0.0, 0.0};
  int whole[]{3, 5};
  ValuesOf<Vector> const vector(*this, two), result(*this, product);
  ValuesOf<Matrix> const matrix(*this, numbers);
  ValuesOf<Id> const id(*this, whole);
  expect(vector.get().size == 2 && vector.get().numbers == two, "a Vector has another layout");
  auto* const multiply = reinterpret_cast<int (*)(Vector*, double, Matrix const*, Vector const*, double)>(
      symbol("_ZN6Vector15addMatrixVectorEdRK6MatrixRKS_d"));
  multiply(&result.get(), 0.0, &matrix.get(), &vector.get(), 1.0);
  expect(product[0] == 210.0 && product[1] == 430.0, "a Matrix has another layout");
  expect(id.get().size == 2 && id.get().numbers == whole, "an ID has another layout");
}

void Program::rehearse() const {
  // Makes the OpenSees material Elastic, a spring with a dashpot, and calls its functions through its table, as
  // OpenSees will call those of isolaw's materials. The results must be those of a spring with a dashpot.
  constexpr std::size_t more_than_it_needs = 1024;
  alignas(16) std::byte memory[more_than_it_needs];
  auto* const construct =
      reinterpret_cast<void (*)(void*, int, double, double, double)>(symbol("_ZN15ElasticMaterialC1Eiddd"));
  construct(memory, 4711, 2.0, 0.5, 2.0);
  auto const* const table = *reinterpret_cast<Function const**>(memory);
  auto const call = [&]<class Result, class... Arguments>(Result*, std::string_view name, Arguments... arguments) {
    auto const place = place_of(uniaxial_material, name) - words_before_functions;
    return reinterpret_cast<Result (*)(void*, Arguments...)>(table[place])(memory, arguments...);
  };
  int const code = call(static_cast<int*>(nullptr), "14setTrialStrainEdd", 0.25, 4.0);
  double const stress = call(static_cast<double*>(nullptr), "9getStressEv");
  double const tangent = call(static_cast<double*>(nullptr), "10getTangentEv");
  double const damping = call(static_cast<double*>(nullptr), "14getDampTangentEv");
  double const rate = call(static_cast<double*>(nullptr), "13getStrainRateEv");
  call(static_cast<void*>(nullptr), "D1Ev");
  expect(code == 0 && stress == 2.5 && tangent == 2.0 && damping == 0.5 && rate == 4.0,
         "its material Elastic gives other values than a spring and a dashpot");
}

void Program::find_members() {
  // The classes of streams differ between versions, so operator<<(char const*) is searched for in the table.
  auto const* const words = static_cast<Function const*>(symbol(table_name("StandardStream")));
  auto const write = reinterpret_cast<Function>(symbol("_ZN14StandardStreamlsEPKc"));
  constexpr std::size_t most_words = 64;
  auto const* const found = std::find(words, words + most_words, write);
  expect(found != words + most_words, "a stream has another layout");
  text_to_stream_ = static_cast<std::size_t>(found - words) - words_before_functions;

  // The layout of Information differs between versions too, so the place of its number is searched for.
  constexpr std::size_t more_than_it_needs = 512;
  constexpr double number = 1.2345678;
  alignas(16) std::byte memory[more_than_it_needs] = {};
  reinterpret_cast<void (*)(void*, double)>(symbol("_ZN11InformationC1Ed"))(memory, number);
  std::size_t places = 0;
  for (std::size_t at = 0; at + sizeof(double) <= more_than_it_needs; at += sizeof(double))
    if (std::memcmp(memory + at, &number, sizeof(double)) == 0) value_in_information_ = at, ++places;
  expect(places == 1, "an Information has another layout");
}

void Program::write(void* stream, std::string const& text) const {
  auto const* const table = *static_cast<Function const* const*>(stream);
  reinterpret_cast<void* (*)(void*, char const*)>(table[text_to_stream_])(stream, text.c_str());
}

double Program::value_in(void const* information) const {
  double value = 0.0;
  std::memcpy(&value, static_cast<std::byte const*>(information) + value_in_information_, sizeof(double));
  return value;
}

std::optional<Program::Motion> Program::motion_of_active_element() const {
  Motion motion;
  void* const element = *calls_.active_element;
  auto const* const functions = calls_.zero_length_section + words_before_functions;
  if (element == nullptr || *static_cast<Function const**>(element) != functions) return std::nullopt;
  auto* const* const nodes = calls_.nodes_of(element);
  for (int end = 0; end < 2; ++end) {
    if (nodes[end] == nullptr) return std::nullopt;
    auto const add = [&](std::array<double, 3>& sum, Vector const& of_node) {
      // A node in space has 6 degrees of freedom, of which the first 3 are displacements.
      int const directions = of_node.size == 6 ? 3 : std::min(of_node.size, 2);
      for (int i = 0; i < directions; ++i)
        sum[static_cast<std::size_t>(i)] += (end == 0 ? -1.0 : 1.0) * of_node.numbers[i];
    };
    add(motion.displacement, *calls_.displacement_of(nodes[end]));
    add(motion.velocity, *calls_.velocity_of(nodes[end]));
  }
  return motion;
}

void complain(Program const& program, std::string const& sentence) {
  program.write(*program.calls().errors, sentence + "\n");
}

}  // namespace isolaw::opensees
