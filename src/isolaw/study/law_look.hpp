// How each law is drawn on the page and in printed figures. Colour-blind readers can tell the colours apart (after
// Okabe, Ito 2008). No law is grey, because measured data are grey. Each colour has a variant for a dark screen, and
// the markers stay distinct in grey print.
#pragma once

#include <cstddef>
#include <iterator>
#include <string_view>

namespace isolaw::study {

struct LawLook {
  std::string_view colour, on_dark;
  std::string_view symbol;    // the marker on the page
  int point = 0, hollow = 0;  // gnuplot's markers, filled and hollow
};

inline constexpr LawLook law_looks[]{
    {"#0072b2", "#56a8e0", "circle", 7, 6},
    {"#bf4408", "#ff8a4c", "square", 5, 4},
    {"#009e73", "#35c49a", "diamond", 13, 12},
    {"#b8558f", "#e08fc0", "triangle-up", 9, 8},
    {"#d99a00", "#f0b93a", "triangle-down", 11, 10},
    {"#3aa0dc", "#8fd0f7", "cross", 1, 1},
    {"#6b4fa0", "#a98fe0", "x", 2, 2},
    {"#7a5230", "#c79a74", "star", 3, 3},
};
inline constexpr std::size_t law_look_count = std::size(law_looks);

// The look of Summary::laws[law], as an index in law_looks. After law_look_count laws the looks repeat with hollow
// markers.
constexpr std::size_t look_of(std::size_t law) {
  return law % law_look_count;
}
constexpr bool is_hollow(std::size_t law) {
  return law >= law_look_count;
}

// gnuplot's markers in the plot of accuracy against robustness: filled for a law on the front, hollow for a law that
// another law beats, a cross for an inadequate law.
inline constexpr int front_point = 7, beaten_point = 12, inadequate_point = 2;

}  // namespace isolaw::study
