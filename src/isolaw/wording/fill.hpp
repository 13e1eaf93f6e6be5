// Makes a sentence from a text that holds fields of findings in braces, such as "{law} is {error:%} off {measure}".
//   {name}        a word of the finding (or its phrase, if fill.cpp has one for it), or a number
//   {name:SPEC}   a number in the form SPEC: `3` prints 3 significant digits, `,` a whole number with commas at
//                 thousands, `.1f` what fmt prints. `%` prints 0.042 as "4.2 %", `%1` the same but always with one
//                 decimal, `0%` prints it as "4 %", and `few%` as "only 4.2 %", or 0 as "none". {name:law} prints the
//                 name of the law whose id is the word `name`
//   {name_mm:3}   a number whose name ends with a unit of force or length. It is printed in the reader's units and
//                 followed by the unit; {name_mm:3!} leaves the unit out. For {name:3 unit} the unit is the finding's
//                 word `unit`; without such a word, no unit is printed. {name:unit3} prints the number {name}_UNIT,
//                 where UNIT is the word `unit`
//   {law} {laws} {devices} {parameters} {block}   the members of the finding; {laws} are the other laws
//   {one|many}    chosen by the list or the number that was printed last
//   [ ... ]       left out if a field inside is absent, or if a number inside that is written as {name} is 0
//   < ... >       repeated for each finding, and names its device if there are several
//   ~ ... ~       repeated for each finding too, but never names the device
// If the findings of a group have different values of a number, their range is printed.
#pragma once

#include <string>
#include <string_view>

#include "isolaw/wording/table.hpp"

namespace isolaw::wording {

std::string fill(std::string_view text, Group group, UnitSystem const& units);

}  // namespace isolaw::wording
