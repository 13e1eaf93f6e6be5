#include "isolaw/base/symbol.hpp"

#include <algorithm>
#include <array>

#include "isolaw/base/words.hpp"

namespace isolaw {
namespace {

struct Letter {
  std::string_view name, sign, latex;
};

// greek_at_head() finds the first of these names with which a text begins. If one name is the beginning of another, the
// longer name must therefore come first.
constexpr auto greek = std::to_array<Letter>({
    {"alpha", "α", "\\alpha"},
    {"beta", "β", "\\beta"},
    {"gamma", "γ", "\\gamma"},
    {"delta", "δ", "\\delta"},
    {"epsilon", "ε", "\\varepsilon"},
    {"zeta", "ζ", "\\zeta"},
    {"eta", "η", "\\eta"},
    {"theta", "θ", "\\theta"},
    {"lambda", "λ", "\\lambda"},
    {"mu", "μ", "\\mu"},
    {"nu", "ν", "\\nu"},
    {"xi", "ξ", "\\xi"},
    {"rho", "ρ", "\\rho"},
    {"sigma", "σ", "\\sigma"},
    {"tau", "τ", "\\tau"},
    {"phi", "φ", "\\varphi"},
    {"psi", "ψ", "\\psi"},
    {"omega", "ω", "\\omega"},
});

Letter const* greek_at_head(std::string_view text) {
  auto const found = std::ranges::find_if(greek, [&](Letter const& letter) { return text.starts_with(letter.name); });
  return found == greek.end() ? nullptr : &*found;
}
Letter const* greek_letter(std::string_view text) {
  auto const* found = greek_at_head(text);
  return found != nullptr && found->name == text ? found : nullptr;
}

std::string index_of(std::string_view text) {
  if (text.starts_with('_')) text.remove_prefix(1);
  if (auto const* letter = greek_letter(text)) return std::string(letter->sign);
  std::string index(text);
  std::ranges::replace(index, '_', ' ');
  return index;
}

std::string with_signs(std::string index) {
  constexpr std::string_view both = "±";
  if (auto const at = index.find(both); at != std::string::npos) index.replace(at, both.size(), "\\pm");
  return index;
}

}  // namespace

Symbol symbol_of(std::string_view name) {
  if (name.empty()) return {};
  if (name == "OF") return {"OF", "\\mathit{OF}", {}};  // the objective function has a symbol of two letters
  if (auto const* letter = greek_at_head(name))
    return {letter->sign, letter->latex, index_of(name.substr(letter->name.size()))};
  auto const rest = name.substr(1);  // "dpsi", the growth of psi with work, becomes delta with the index psi
  if (name.front() == 'd')
    if (auto const* degrading = greek_letter(rest)) return {"δ", "\\delta", std::string(degrading->sign)};
  return {name.substr(0, 1), {}, index_of(rest)};
}

std::string latex_symbol(std::string_view name) {
  auto const symbol = symbol_of(name);
  auto text = "$" + std::string(symbol.latex.empty() ? symbol.letter : symbol.latex);
  if (!symbol.index.empty()) {
    auto const letter = std::ranges::find(greek, symbol.index, &Letter::sign);
    bool const words = std::ranges::count_if(symbol.index, is_letter) > 1;
    text += "_{" +
            (letter != greek.end() ? std::string(letter->latex)
             : words               ? "\\mathrm{" + symbol.index + "}"
                                   : with_signs(symbol.index)) +
            "}";
  }
  return text + "$";
}

std::string gnuplot_symbol(std::string_view name) {
  auto const symbol = symbol_of(name);
  auto const letter = "{/:Italic " + std::string(symbol.letter) + "}";
  return symbol.index.empty() ? letter : letter + "_{" + symbol.index + "}";
}

std::vector<std::string_view> symbol_words() {
  std::vector<std::string_view> words{"K_eff",       "K_d",         "K_v",        "Q_d",
                                      "lambda_test", "lambda_spec", "lambda_min", "lambda_max"};
  for (auto const& letter : greek) words.push_back(letter.name);
  return words;
}

}  // namespace isolaw
