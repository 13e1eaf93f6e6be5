#include "isolaw/rules/effects.hpp"

#include <array>
#include <cstddef>

namespace isolaw::rules {
namespace {

template <class Value, std::size_t count>
constexpr auto in_order() {  // all enumerators of Value, in order
  std::array<Value, count> all{};
  for (std::size_t i = 0; i < count; ++i) all[i] = static_cast<Value>(i);
  return all;
}

constexpr std::array<std::string_view, 8> effect_names{"temperature", "rate",   "load",          "ageing",
                                                       "scragging",   "cycles", "contamination", "environment"};
constexpr std::array<std::string_view, 3> group_names{"environment", "test", "none"};
constexpr std::array<std::string_view, 4> form_names{"asce", "each", "product", "sum"};
constexpr auto all_effects = in_order<Effect, effect_names.size() - 1>();  // all but the last, the environment
constexpr auto all_groups = in_order<Group, group_names.size()>();
constexpr auto all_forms = in_order<Form, form_names.size()>();

}  // namespace

std::span<Effect const> effects() {
  return all_effects;
}

std::string_view name(Effect effect) {
  return effect_names.at(static_cast<std::size_t>(effect));
}

std::span<Group const> groups() {
  return all_groups;
}

std::string_view name(Group group) {
  return group_names.at(static_cast<std::size_t>(group));
}

Group usual_group(Effect effect) {
  switch (effect) {
    case Effect::temperature:
    case Effect::ageing:
    case Effect::contamination:
    case Effect::environment:
      return Group::environment;
    case Effect::load:
      return Group::none;
    default:
      return Group::test;
  }
}

std::span<Form const> forms() {
  return all_forms;
}

std::string_view name(Form form) {
  return form_names.at(static_cast<std::size_t>(form));
}

}  // namespace isolaw::rules
