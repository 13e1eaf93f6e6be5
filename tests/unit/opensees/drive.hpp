// Drives an exported material as an analysis does and prints force, tangent and damping at each point. A failed check
// prints a line of its own.
#pragma once

#include <cmath>
#include <cstdio>
#include <memory>

#include "program.hpp"

struct Point {
  double x, v;
};

inline void require(bool holds, char const* what) {
  if (!holds) std::printf("%s\n", what);
}

inline std::unique_ptr<UniaxialMaterial> material_of(void* (*parse)(), std::vector<std::string> const& given,
                                                     bool in_python = false) {
  words = given;
  next_word = 0;
  python = in_python;
  return std::unique_ptr<UniaxialMaterial>(static_cast<UniaxialMaterial*>(parse()));
}

template <class UserMaterial, std::size_t count>
void drive(void* (*parse)(), Point const (&motion)[count]) {
  for (bool const in_python : {false, true}) {
    for (std::vector<std::string> const& wrong :
         {std::vector<std::string>{}, {"x"}, {"1", "most"}, {"1", "-2"}, {"1", "0"}, {"1", "1", "1"}})
      require(material_of(parse, wrong, in_python) == nullptr && OPS_GetNumRemainingInputArgs() >= 0,
              "wrong arguments are taken");
    auto const own = material_of(parse, {"4", "1.5"}, in_python), plain = material_of(parse, {"4"}, in_python);
    require(own != nullptr && plain != nullptr, "arguments are refused");
    own->setTrialStrain(motion[3].x, motion[3].v);
    plain->setTrialStrain(motion[3].x, motion[3].v);
    require(std::abs(own->getStress() - 1.5 * plain->getStress()) <= 1e-12 * std::abs(own->getStress()),
            "the factor is lost");
  }
  auto m = material_of(parse, {"4", "upper"});
  require(m != nullptr && m->getTag() == 4, "not made");
  std::unique_ptr<UniaxialMaterial> other(m->getCopy()), fresh(m->getCopy());
  require(m->getTangent() == m->getInitialTangent(), "the first tangent is not that of the start");
  double const first_tangent = m->getInitialTangent();
  FEM_ObjectBroker broker;
  for (std::size_t i = 0; i < count; ++i) {
    auto const [x, v] = motion[i];
    m->setTrialStrain(-3.0 * x, 2.0 * v);
    m->revertToLastCommit();
    if (i % 2 == 1) {
      m->setTrialStrain(2.0 * x, v);  // sendSelf must send the last committed state, not this trial
      Memory channel;
      require(m->sendSelf(1, channel) == 0, "not sent");
      std::unique_ptr<UniaxialMaterial> received(new UserMaterial());
      require(received->recvSelf(1, channel, broker) == 0, "not received");
      require(channel.vectors.empty() && channel.ids.empty(), "messages are left over");
      m->revertToLastCommit();
      require(received->getTag() == 4 && received->getStrain() == m->getStrain() &&
                  received->getStress() == m->getStress() && received->getStrainRate() == m->getStrainRate() &&
                  received->getInitialTangent() == first_tangent && received->getTangent() == m->getTangent() &&
                  received->getDampTangent() == m->getDampTangent(),
              "another state was received");
      // A message of the wrong length must be refused and leave the receiving material unchanged.
      for (int const more : {-1, 1}) {
        m->sendSelf(1, channel);
        channel.ids.front()[1] += more;
        channel.vectors.front().resize(channel.vectors.front().size() + static_cast<std::size_t>(more), 0.5);
        double const force = received->getStress();
        require(received->recvSelf(1, channel, broker) < 0 && received->getStress() == force, "a wrong state is taken");
        channel.ids.clear();
        channel.vectors.clear();
      }
      m = std::move(received);
    }
    if (i % 5 == 2) {
      // Committing a state in the copy must not change the original.
      std::unique_ptr<UniaxialMaterial> copy(m->getCopy());
      require(copy->getTag() == 4 && copy->getStress() == m->getStress(), "the copy is another");
      copy->setTrialStrain(-x, -v);
      copy->commitState();
    }
    double force = 0.0, tangent = 0.0;
    require(m->setTrial(x, force, tangent, v) == 0, "failed");
    require(force == m->getStress() && tangent == m->getTangent() && x == m->getStrain() && v == m->getStrainRate(),
            "setTrial gives other numbers");
    std::printf("%.17g %.17g %.17g\n", force, tangent, m->getDampTangent());
    m->commitState();
    // A second material of the same kind, driven in turn with the first, must not change the first.
    other->setTrialStrain(0.5 * x, 0.5 * v);
    other->commitState();
  }
  OPS_Stream json, people;
  m->Print(json, OPS_PRINT_PRINTMODEL_JSON);
  m->Print(people);
  require(json.text.str().find("{\"name\": \"4\", \"type\": \"" + std::string(m->getClassType()) +
                               "\", \"factor\": 1.15}") != std::string::npos,
          "Print in JSON");
  require(people.text.str().find("tag: 4") != std::string::npos, "Print");
  m->revertToStart();
  m->setTrialStrain(motion[2].x, motion[2].v);
  fresh->setTrialStrain(motion[2].x, motion[2].v);
  require(m->getStress() == fresh->getStress() && m->getInitialTangent() == first_tangent, "not at the start");
  require(m->setTrialStrain(std::nan(""), 0.0) != 0, "no number is taken");
}
