// Gives a law to the running OpenSees as a UniaxialMaterial (program.hpp).
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <exception>
#include <memory>
#include <new>
#include <span>
#include <string_view>

#include "isolaw/base/error.hpp"
#include "isolaw/laws/online/online.hpp"
#include "law.hpp"
#include "tables.hpp"

namespace isolaw::opensees {
namespace {

struct Material {
  alignas(16) std::byte base[32];  // OpenSees' part of the object, a UniaxialMaterial
  Program const* program;
  std::shared_ptr<Law const> about;
  std::shared_ptr<laws::Online const> virgin;
  laws::Online law;
  double factor;
  struct State {
    double disp = 0.0, velocity = 0.0, energy = 0.0;  // in the model's units; `energy` is the work of factor * force
    laws::Online::Force force = {};                   // in the law's units, without the factor
  } trial = {}, committed = {};

  double to_force() const { return factor * about->force_from_law; }
  double to_stiffness() const { return to_force() * about->length_to_law; }
};

constexpr std::string_view class_type = "isolaw";

Material* make(Program const& program, int tag, std::shared_ptr<Law const> about,
               std::shared_ptr<laws::Online const> virgin, double factor);

int try_strain(Material* self, double disp, double velocity) noexcept try {
  auto const& about = *self->about;
  self->trial.disp = disp;
  self->trial.velocity = velocity;
  self->trial.force = self->law.trial(disp * about.length_to_law, velocity * about.length_to_law);
  auto const& force = self->trial.force;
  if (std::isfinite(disp) && std::isfinite(velocity) && std::isfinite(force.force) && std::isfinite(force.by_x))
    return 0;
  complain(*self->program,
           fmt::format(
               "isolaw material {}: the law {} has no force at displacement {:g}, velocity {:g}; take a smaller step",
               tag_of(self), about.id, disp, velocity));
  return -1;
} catch (std::exception const& error) {
  complain(*self->program, fmt::format("isolaw material {}: {}", tag_of(self), error.what()));
  return -1;
}

int commit(Material* self) noexcept {
  auto& [disp, velocity, energy, force] = self->trial;
  auto const& before = self->committed;
  energy = before.energy + 0.5 * self->to_force() * (force.force + before.force.force) * (disp - before.disp);
  self->law.commit();
  self->committed = self->trial;
  return 0;
}

int revert(Material* self) noexcept {
  self->trial = self->committed;
  return 0;
}

int restart(Material* self) noexcept try {
  self->law = *self->virgin;
  self->committed = {};
  self->committed.force = self->law.trial(0.0, 0.0);
  return revert(self);
} catch (std::exception const&) {
  return -1;
}

Material* copy(Material* self) noexcept try {
  auto* const made = make(*self->program, tag_of(self), self->about, self->virgin, self->factor);
  made->law = self->law;
  made->trial = self->trial;
  made->committed = self->committed;
  return made;
} catch (std::exception const&) {
  return nullptr;
}

void destroy(Material* self) noexcept {
  auto const* const program = self->program;
  std::destroy_at(self);
  program->calls().end_material(self->base);
}

double initial_tangent(Material* self) noexcept try {
  auto law = *self->virgin;
  return self->to_stiffness() * law.trial(0.0, 0.0).by_x;
} catch (std::exception const&) {
  return 0.0;
}

void* set_response(Material* self, char const** words, int count, void* stream) noexcept try {
  auto const& program = *self->program;
  std::string_view const name = count > 0 ? words[0] : "";
  if (name == "energy") return new_response(program, self, energy_response, {0.0});
  if (name == "state") return new_response(program, self, state_response, self->law.state());
  char const* const as_stress[]{name == "force" ? "stress" : "strain"};
  bool const is_other_name = name == "force" || name == "deformation";
  return program.calls().set_response(self, is_other_name ? as_stress : words, count, stream);
} catch (std::exception const&) {
  return nullptr;
}

int get_response(Material* self, int response, void* information) noexcept try {
  auto const& program = *self->program;
  if (response == energy_response) return give(program, {self->trial.energy}, information);
  if (response == state_response) return give(program, self->law.state(), information);
  return program.calls().get_response(self, response, information);
} catch (std::exception const&) {
  return -1;
}

// The table of virtual functions of all Material objects: a copy of OpenSees' table of UniaxialMaterial, in which
// functions of this file replace those of OpenSees.
Table table_with_own_functions(Program const& program) {
  TableWithOwn table(program, uniaxial_material);
  table.own(
      "D1Ev", +[](Material* self) { destroy(self); });
  table.own(
      "D0Ev", +[](Material* self) {
        destroy(self);
        ::operator delete(self);
      });
  table.own(
      "5PrintER10OPS_Streami", +[](Material* self, void* stream, int flag) {
        self->program->write(
            stream,
            flag == printed_as_json
                ? fmt::format(R"(			{{"name": "{}", "type": "isolaw", "law": "{}", "factor": {}}})",
                              tag_of(self), self->about->id, self->factor)
                : fmt::format("isolaw tag: {}, law {}, factor {:g}, displacement {:g}, force {:g}\n", tag_of(self),
                              self->about->id, self->factor, self->trial.disp,
                              self->to_force() * self->trial.force.force));
      });
  table.own("11setResponseEPPKciR10OPS_Stream", &set_response);
  table.own("11getResponseEiR11Information", &get_response);
  table.own("14setTrialStrainEdd", &try_strain);
  table.own(
      "9getStrainEv", +[](Material* self) { return self->trial.disp; });
  table.own(
      "13getStrainRateEv", +[](Material* self) { return self->trial.velocity; });
  table.own(
      "9getStressEv", +[](Material* self) { return self->to_force() * self->trial.force.force; });
  table.own(
      "10getTangentEv", +[](Material* self) { return self->to_stiffness() * self->trial.force.by_x; });
  table.own(
      "14getDampTangentEv", +[](Material* self) { return self->to_stiffness() * self->trial.force.by_v; });
  table.own("17getInitialTangentEv", &initial_tangent);
  table.own("11commitStateEv", &commit);
  table.own("18revertToLastCommitEv", &revert);
  table.own("13revertToStartEv", &restart);
  table.own("7getCopyEv", &copy);
  table.own(
      "9getEnergyEv", +[](Material* self) { return self->trial.energy; });
  table.own(
      "20getStressSensitivityEib", +[](Material* self, int, bool) { return no_sensitivity(*self->program); });
  AsMovable<Material>::put_into(table);
  return table.take();
}

Material* make(Program const& program, int tag, std::shared_ptr<Law const> about,
               std::shared_ptr<laws::Online const> virgin, double factor) {
  static Table const table = table_with_own_functions(program);
  auto* const made = new Material{
      .base = {}, .program = &program, .about = std::move(about), .virgin = virgin, .law = *virgin, .factor = factor};
  construct_base(program, uniaxial_material, table, made->base, tag);
  restart(made);
  return made;
}

}  // namespace

void add_material(Program const& program, int tag, IsolawLaw const& given) {
  auto const virgin =
      std::make_shared<laws::Online>(given.id, std::span(given.parameters, given.count), given.dead_band, given.parts);
  auto* const made = make(program, tag, std::make_shared<Law>(given), virgin, given.factor);
  if (program.calls().add_material(made)) return;
  destroy(made);
  ::operator delete(made);
  throw Error({.where = fmt::format("material {}", tag),
               .found = "a material of this tag exists already",
               .allowed = "a tag of its own for each material"});
}

}  // namespace isolaw::opensees
