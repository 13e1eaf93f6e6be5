// Gives a law in two directions to the running OpenSees as a SectionForceDeformation. The deformations are the
// displacements along the local axes y and z; OpenSees calls these responses VY and VZ.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <memory>
#include <span>
#include <string_view>

#include "isolaw/base/error.hpp"
#include "isolaw/laws/plane/in_plane.hpp"
#include "law.hpp"
#include "tables.hpp"
#include "values.hpp"

namespace isolaw::opensees {
namespace {

using Plane = laws::plane::Vector<double>;

struct Shared : Law {
  laws::InPlane virgin;
  Plane axis_in[3];  // the local axes' components along each global axis

  explicit Shared(IsolawLaw const& given)
      : Law(given),
        virgin(given.springs == 0 ? laws::InPlane::coupled(given.id, {given.parameters, given.count})
                                  : laws::InPlane::springs(laws::Online(given.id, {given.parameters, given.count},
                                                                        given.dead_band, given.parts),
                                                           given.springs)) {
    for (std::size_t i = 0; i < 3; ++i) axis_in[i] = {given.axes[0][i], given.axes[1][i]};
  }
};

struct Section {
  struct State {
    double disp[2] = {}, force[2] = {}, tangent[4] = {};  // in the model's units, without the factor
  };

  alignas(16) std::byte base[48];  // OpenSees' part of the object, a SectionForceDeformation
  Program const* program;
  std::shared_ptr<Shared const> about;
  laws::InPlane law;
  double factor;
  State trial, committed;
  double initial_tangent[4];
  double shown[2], shown_tangent[4];  // force and tangent times the factor, as last returned to OpenSees
  ValuesOf<Vector> disp_vector, force_vector;
  ValuesOf<Matrix> tangent_matrix;

  Section(Program const& of, std::shared_ptr<Shared const> shared, double given_factor)
      : program(&of),
        about(std::move(shared)),
        law(about->virgin),
        factor(given_factor),
        disp_vector(of, trial.disp),
        force_vector(of, shown),
        tangent_matrix(of, shown_tangent) {}
};

void restart(Section& self);

void set_state(Section& self, laws::InPlane::Force const& force, double by_velocity) {
  auto const& about = *self.about;
  self.trial.force[0] = about.force_from_law * force.force.x;
  self.trial.force[1] = about.force_from_law * force.force.y;
  for (std::size_t row = 0; row < 2; ++row)
    for (std::size_t column = 0; column < 2; ++column)
      self.trial.tangent[2 * column + row] =
          about.force_from_law * about.length_to_law *
          (force.by_displacement[row][column] + by_velocity * force.by_velocity[row][column]);
}

int try_deformation(Section* self, Vector const* deformation) noexcept try {
  auto const& about = *self->about;
  for (std::size_t i = 0; i < 2; ++i) self->trial.disp[i] = deformation->numbers[i];
  Plane const disp{about.length_to_law * self->trial.disp[0], about.length_to_law * self->trial.disp[1]};
  Plane velocity{0.0, 0.0};
  double by_velocity = 0.0;
  double const dt = *self->program->calls().time_step;
  if (about.depends_on_velocity) {
    auto const refuse = [&](std::string_view why) {
      complain(*self->program,
               fmt::format("isolaw section {}: the law {} takes its velocity from a zeroLengthSection, {}",
                           tag_of(self), about.id, why));
      return -1;
    };
    auto const motion = self->program->motion_of_active_element();
    if (!motion) return refuse("and this is another element");
    Plane expected{0.0, 0.0};
    for (std::size_t i = 0; i < 3; ++i) {
      expected = expected + (about.length_to_law * motion->displacement[i]) * about.axis_in[i];
      velocity = velocity + (about.length_to_law * motion->velocity[i]) * about.axis_in[i];
    }
    auto const& u = motion->displacement;
    if (std::hypot(disp.x - expected.x, disp.y - expected.y) >
        1e-6 * about.length_to_law * std::hypot(u[0], u[1], u[2]))
      return refuse("whose -orient differs from the orient that isolaw.opensees.section() was given");
    // OpenSees takes no damping matrix from a section, so the derivative of the force with respect to velocity is added
    // to the tangent. In Newmark's method with constant average acceleration, a change u of displacement changes the
    // velocity by 2 u / dt.
    if ((velocity.x != 0.0 || velocity.y != 0.0) && dt > 0.0) by_velocity = 2.0 / dt;
  }
  auto const force = self->law.trial(disp, velocity, dt);
  set_state(*self, force, by_velocity);
  if (std::isfinite(disp.x) && std::isfinite(disp.y) && std::isfinite(force.force.x) && std::isfinite(force.force.y))
    return 0;
  complain(*self->program,
           fmt::format("isolaw section {}: the law {} has no force at displacements {:g} and {:g}; take a smaller step",
                       tag_of(self), about.id, self->trial.disp[0], self->trial.disp[1]));
  return -1;
} catch (std::exception const& error) {
  complain(*self->program, fmt::format("isolaw section {}: {}", tag_of(self), error.what()));
  return -1;
}

void restart(Section& self) {
  self.law = self.about->virgin;
  self.trial = {};
  set_state(self, self.law.trial({0.0, 0.0}, {0.0, 0.0}, 1.0), 0.0);
  self.committed = self.trial;
}

Section* make(Program const& program, int tag, std::shared_ptr<Shared const> about, double factor);

Section* copy(Section* self) noexcept try {
  auto* const made = make(*self->program, tag_of(self), self->about, self->factor);
  made->law = self->law;
  made->trial = self->trial;
  made->committed = self->committed;
  return made;
} catch (std::exception const&) {
  return nullptr;
}

void destroy(Section* self) noexcept {
  auto const* const program = self->program;
  std::destroy_at(self);
  program->calls().end_section(self->base);
}

void* set_response(Section* self, char const** words, int count, void* stream) noexcept try {
  auto const& program = *self->program;
  if (count > 0 && std::string_view(words[0]) == "state")
    return new_response(program, self, state_response, self->law.state());
  return program.calls().set_section_response(self, words, count, stream);
} catch (std::exception const&) {
  return nullptr;
}

int get_response(Section* self, int response, void* information) noexcept try {
  if (response == state_response) return give(*self->program, self->law.state(), information);
  return self->program->calls().get_section_response(self, response, information);
} catch (std::exception const&) {
  return -1;
}

Matrix* shown_tangent(Section* self, double const (&tangent)[4]) {
  for (std::size_t i = 0; i < 4; ++i) self->shown_tangent[i] = self->factor * tangent[i];
  return &self->tangent_matrix.get();
}

Id* directions(Program const& program) {
  static int codes[]{3, 5};  // SECTION_RESPONSE_VY and SECTION_RESPONSE_VZ
  static ValuesOf<Id> const id(program, codes);
  return &id.get();
}

Table table_with_own_functions(Program const& program) {
  TableWithOwn table(program, section_force_deformation);
  table.own(
      "D1Ev", +[](Section* self) { destroy(self); });
  table.own(
      "D0Ev", +[](Section* self) {
        destroy(self);
        ::operator delete(self);
      });
  table.own(
      "5PrintER10OPS_Streami", +[](Section* self, void* stream, int flag) {
        self->program->write(
            stream,
            flag == printed_as_json
                ? fmt::format(R"(			{{"name": "{}", "type": "isolaw", "law": "{}", "factor": {}}})",
                              tag_of(self), self->about->id, self->factor)
                : fmt::format(
                      "isolaw section tag: {}, law {}, factor {:g}, displacements {:g} and {:g}, forces {:g} and {:g}\n",
                      tag_of(self), self->about->id, self->factor, self->trial.disp[0], self->trial.disp[1],
                      self->factor * self->trial.force[0], self->factor * self->trial.force[1]));
      });
  table.own("11setResponseEPPKciR10OPS_Stream", &set_response);
  table.own("11getResponseEiR11Information", &get_response);
  table.own("26setTrialSectionDeformationERK6Vector", &try_deformation);
  table.own(
      "21getSectionDeformationEv", +[](Section* self) { return &self->disp_vector.get(); });
  table.own(
      "18getStressResultantEv", +[](Section* self) {
        for (std::size_t i = 0; i < 2; ++i) self->shown[i] = self->factor * self->trial.force[i];
        return &self->force_vector.get();
      });
  table.own(
      "17getSectionTangentEv", +[](Section* self) { return shown_tangent(self, self->trial.tangent); });
  table.own(
      "17getInitialTangentEv", +[](Section* self) { return shown_tangent(self, self->initial_tangent); });
  table.own(
      "11commitStateEv", +[](Section* self) {
        self->law.commit();
        self->committed = self->trial;
        return 0;
      });
  table.own(
      "18revertToLastCommitEv", +[](Section* self) {
        self->trial = self->committed;
        return 0;
      });
  table.own(
      "13revertToStartEv", +[](Section* self) {
        restart(*self);
        return 0;
      });
  table.own("7getCopyEv", &copy);
  table.own(
      "7getTypeEv", +[](Section* self) { return directions(*self->program); });
  table.own(
      "8getOrderEv K", +[](Section*) { return 2; });
  table.own(
      "29getStressResultantSensitivityEib", +[](Section* self, int, bool) {
        self->shown[0] = self->shown[1] = no_sensitivity(*self->program);
        return &self->force_vector.get();
      });
  AsMovable<Section>::put_into(table);
  return table.take();
}

Section* make(Program const& program, int tag, std::shared_ptr<Shared const> about, double factor) {
  static Table const table = table_with_own_functions(program);
  auto* const made = new Section(program, std::move(about), factor);
  construct_base(program, section_force_deformation, table, made->base, tag);
  restart(*made);
  std::copy_n(made->trial.tangent, 4, made->initial_tangent);
  return made;
}

}  // namespace

void add_section(Program const& program, int tag, IsolawLaw const& given) {
  auto* const made = make(program, tag, std::make_shared<Shared>(given), given.factor);
  if (program.calls().add_section(made)) return;
  destroy(made);
  ::operator delete(made);
  throw Error({.where = fmt::format("section {}", tag),
               .found = "a section of this tag exists already",
               .allowed = "a tag of its own for each section"});
}

}  // namespace isolaw::opensees
