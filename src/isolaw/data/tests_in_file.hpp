// Recognises the format of a file and chooses the table with the test that is asked for.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/columns.hpp"
#include "isolaw/data/read.hpp"
#include "isolaw/data/table.hpp"

namespace isolaw::data {

// `bytes` must outlive the tests. Throws Error for an unknown format.
Tests open_tests(std::string_view bytes, std::string const& file, ReadOptions const& options,
                 Wanted wanted = Wanted::test());

// Options without an effect on this file. They are refused and not ignored, because the user meant something by them.
std::vector<std::string> idle_options(std::string_view bytes, ReadOptions const& options);
void refuse_idle(std::vector<std::string> const& idle, std::string const& file);
// Whether --columns names the displacement and, if a force is wanted, the force: these then need not be recognised.
bool columns_are_told(ReadOptions const& options, Wanted wanted);

void require_one_sheet(Tests const& tests, std::string const& file, ReadOptions const& options, Wanted wanted);

// Positions in tests.tables. Throws Error if several tests are possible and the options choose none.
std::vector<std::size_t> chosen_tests(Tests const& tests, std::string const& file, ReadOptions const& options);

}  // namespace isolaw::data
