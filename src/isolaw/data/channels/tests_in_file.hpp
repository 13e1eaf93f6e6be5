// Recognises the format of a file, and chooses the table that holds the wanted test.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/channels/columns.hpp"
#include "isolaw/data/files/table.hpp"

namespace isolaw::data {

// `bytes` must outlive the tests. Throws Error for an unknown format.
Tests open_tests(std::string_view bytes, std::string const& file, ReadOptions const& options,
                 Wanted wanted = Wanted::test());

// Lists the options that have no effect on this file. refuse_idle() refuses them, because the user expects an effect.
std::vector<std::string> idle_options(std::string_view bytes, ReadOptions const& options);
void refuse_idle(std::vector<std::string> const& idle, std::string const& file);
// Whether --columns names the columns of displacement and, if it is wanted, of force. They then need not be recognised.
bool columns_are_told(ReadOptions const& options, Wanted wanted);

void require_one_sheet(Tests const& tests, std::string const& file, ReadOptions const& options, Wanted wanted);

// Positions of the chosen tests in tests.tables. Throws Error if there are several and the options choose none.
std::vector<std::size_t> chosen_tests(Tests const& tests, std::string const& file, ReadOptions const& options);

}  // namespace isolaw::data
