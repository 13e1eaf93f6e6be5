// Makes a sentence from a text with the fields of findings in braces, "{law} is {error:%} off {measure}".
//   {name}        a word of the finding (or its phrase, if fill.cpp has one for it), or a number
//   {name:SPEC}   a number: 3 significant digits `3`, with the unit of its channel `unit3`, with thousands `,`, or as
//                 fmt prints it `.1f`; 0.042 is 4.2 % by `%` and `%1` (always one decimal), 4 % by `0%`, "only
//                 4.2 %" by `few%`, which makes 0 "none"; `law`: a word that is a law's id
//   {law} {laws} {devices} {parameters} {block}   the members of the finding; {laws} are the other laws
//   {one|many}    chosen by the list or the number that was printed last
//   [ ... ]       left out if a field inside is absent, or if a number {name} inside is 0
//   < ... >       repeated for each finding, and names its device if there are several; ~ ... ~ never names the device
// If the findings of a group have different values of a number, their range is printed.
#pragma once

#include <string>
#include <string_view>

#include "isolaw/wording/table.hpp"

namespace isolaw::wording {

std::string fill(std::string_view text, Group group);

}  // namespace isolaw::wording
