// Tests how names and numbers are typeset (base/symbol.hpp, base/number_text.hpp).
#include <gtest/gtest.h>

#include <algorithm>

#include "isolaw/base/number_text.hpp"
#include "isolaw/base/symbol.hpp"
#include "isolaw/laws/catalogue.hpp"

namespace isolaw {
namespace {

TEST(Symbols, AreALetterAndAnIndex) {
  EXPECT_EQ(latex_symbol("K_eff"), "$K_{\\mathrm{eff}}$");
  EXPECT_EQ(latex_symbol("xi_eff"), "$\\xi_{\\mathrm{eff}}$");
  EXPECT_EQ(latex_symbol("beta1"), "$\\beta_{1}$");
  EXPECT_EQ(latex_symbol("alpha"), "$\\alpha$");
  EXPECT_EQ(latex_symbol("a10"), "$a_{10}$");
  EXPECT_EQ(latex_symbol("Fy"), "$F_{y}$");
  EXPECT_EQ(latex_symbol("F_0±"), "$F_{0\\pm}$");
  EXPECT_EQ(latex_symbol("alpha+"), "$\\alpha_{+}$");
  EXPECT_EQ(latex_symbol("pphi"), "$p_{\\varphi}$");
  EXPECT_EQ(latex_symbol("deta"), "$\\delta_{\\eta}$");
  EXPECT_EQ(latex_symbol("OF"), "$\\mathit{OF}$");
  EXPECT_EQ(gnuplot_symbol("xi_eff"), "{/:Italic ξ}_{eff}");
  EXPECT_EQ(gnuplot_symbol("g"), "{/:Italic g}");
}

// No two parameters of a law may have the same symbol.
TEST(Symbols, TellTheParametersOfALawApart) {
  for (auto const& law : laws::catalogue()) {
    std::vector<std::string> set;
    for (auto const& parameter : law.parameters) set.push_back(latex_symbol(parameter.name));
    std::ranges::sort(set);
    EXPECT_EQ(std::ranges::adjacent_find(set), set.end()) << law.info.id;
  }
}

TEST(NumberText, HasNoPowerOfTenBelowAMillion) {
  EXPECT_EQ(number_text(28390.4), "28390");
  EXPECT_EQ(number_text(1999.6), "2000");
  EXPECT_EQ(number_text(0.028391), "0.02839");
  EXPECT_EQ(number_text(16059.41, 3), "16100");
  EXPECT_EQ(number_text(-12345.6), "-12350");
  EXPECT_EQ(number_text(2.5e6), "2.5e+06");
  EXPECT_EQ(number_text(0.0), "0");
}

}  // namespace
}  // namespace isolaw
