// What a file holds: its format, and which of its tables is the test that is asked for.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/columns.hpp"
#include "isolaw/data/read.hpp"
#include "isolaw/data/table.hpp"

namespace isolaw::data {

// The tests of a file's bytes, which `bytes` must outlive. Throws Error where they are of no kind that is read.
Tests open_tests(std::string_view bytes, std::string const& file, ReadOptions const& options,
                 Wanted wanted = Wanted::test());

// Options that do nothing in a file of its kind, as they are typed; refused, for what is typed is meant.
std::vector<std::string> idle_options(std::string_view bytes, ReadOptions const& options);
void refuse_idle(std::vector<std::string> const& idle, std::string const& file);

// Whether --columns says all that would have to be recognised.
bool columns_are_told(ReadOptions const& options, Wanted wanted);

void require_one_sheet(Tests const& tests, std::string const& file, ReadOptions const& options, Wanted wanted);

// The tests to read, as positions; throws Error where nothing says which of several.
std::vector<std::size_t> chosen_tests(Tests const& tests, std::string const& file, ReadOptions const& options);

}  // namespace isolaw::data
