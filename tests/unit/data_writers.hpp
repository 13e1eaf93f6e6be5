// Writes files of every format. The libraries that write them are not those with which isolaw reads them.
#pragma once

#include <matio.h>
#include <minizip/zip.h>
#include <xlsxwriter.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "data_fixture.hpp"
#include "isolaw/data/files/text.hpp"

namespace isolaw::data::testing {

// Names of columns and their values.
using Named = std::vector<std::pair<std::string, std::vector<double>>>;

inline Named columns_of(Ellipse const& loop, std::string const& time = "Time [s]",
                        std::string const& disp = "Disp [mm]", std::string const& force = "Force [kN]") {
  Named columns{{time, {}}, {disp, {}}, {force, {}}};
  for (int i = 0; i < loop.size(); ++i) {
    columns[0].second.push_back(0.01 * i);
    columns[1].second.push_back(loop.disp(i));
    columns[2].second.push_back(loop.force(i));
  }
  return columns;
}

inline std::string bytes_of(std::filesystem::path const& file) {
  return load_text(file);
}

inline std::string shortest(double value) {
  return fmt::format("{}", value);
}

inline std::string csv_of(Named const& columns) {
  std::string text;
  for (std::size_t c = 0; c < columns.size(); ++c) text += (c == 0 ? "" : ";") + columns[c].first;
  for (std::size_t i = 0; i < columns.front().second.size(); ++i) {
    text += '\n';
    for (std::size_t c = 0; c < columns.size(); ++c) text += (c == 0 ? "" : ";") + shortest(columns[c].second[i]);
  }
  return text + '\n';
}

// --- workbooks ---

// Adds a sheet by libxlsxwriter, with the names in row `first` (counted from 0) and the values below them.
inline void add_sheet(lxw_workbook* book, std::string const& name, Named const& columns, lxw_row_t first = 0) {
  auto* sheet = workbook_add_worksheet(book, name.c_str());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    auto const column = static_cast<lxw_col_t>(c);
    worksheet_write_string(sheet, first, column, columns[c].first.c_str(), nullptr);
    for (std::size_t i = 0; i < columns[c].second.size(); ++i)
      worksheet_write_number(sheet, first + 1 + static_cast<lxw_row_t>(i), column, columns[c].second[i], nullptr);
  }
}

inline std::string workbook_of(std::filesystem::path const& file,
                               std::vector<std::pair<std::string, Named>> const& sheets) {
  auto* book = workbook_new(file.c_str());
  for (auto const& [name, columns] : sheets) add_sheet(book, name, columns);
  workbook_close(book);
  return bytes_of(file);
}

// Returns a zip archive with these entries.
inline std::string zip_of(std::filesystem::path const& file,
                          std::vector<std::pair<std::string, std::string>> const& parts) {
  auto* archive = zipOpen64(file.c_str(), APPEND_STATUS_CREATE);
  for (auto const& [name, text] : parts) {
    zip_fileinfo info{};
    zipOpenNewFileInZip(archive, name.c_str(), &info, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED, 9);
    zipWriteInFileInZip(archive, text.data(), static_cast<unsigned>(text.size()));
    zipCloseFileInZip(archive);
  }
  zipClose(archive, nullptr);
  return bytes_of(file);
}

// Returns the smallest workbook that has a sheet with these rows, given as XML.
inline std::string workbook_with(std::filesystem::path const& file, std::string const& rows,
                                 std::vector<std::pair<std::string, std::string>> more = {}) {
  std::string const relations = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
  std::vector<std::pair<std::string, std::string>> parts{
      {"xl/workbook.xml", "<workbook xmlns:r=\"" + relations +
                              "\"><sheets><sheet name=\"Test\" sheetId=\"1\" r:id=\"a\"/></sheets></workbook>"},
      {"xl/_rels/workbook.xml.rels", "<Relationships><Relationship Id=\"a\" Type=\"" + relations +
                                         "/worksheet\" Target=\"worksheets/sheet1.xml\"/></Relationships>"},
      {"xl/worksheets/sheet1.xml", rows.starts_with("<?") || rows.starts_with("<!")
                                       ? rows
                                       : "<worksheet><sheetData>" + rows + "</sheetData></worksheet>"}};
  parts.insert(parts.end(), more.begin(), more.end());
  return zip_of(file, parts);
}

// --- MATLAB ---

// Writes a MATLAB file by libmatio: version 5 or 7.3, plain or compressed.
class MatWriter {
 public:
  MatWriter(std::filesystem::path file, mat_ft version, matio_compression compression = MAT_COMPRESSION_NONE)
      : file_(std::move(file)), compression_(compression) {
    std::filesystem::remove(file_);
    mat_ = Mat_CreateVer(file_.c_str(), nullptr, version);
  }
  MatWriter(MatWriter const&) = delete;
  MatWriter& operator=(MatWriter const&) = delete;
  ~MatWriter() { Mat_Close(mat_); }

  // Adds a matrix, whose values are given column by column.
  MatWriter& array(std::string const& name, std::vector<double> values, std::size_t columns = 1) {
    return add(variable(name.c_str(), values, columns));
  }
  MatWriter& integers(std::string const& name, std::vector<std::int16_t> values) {
    std::size_t size[2] = {values.size(), 1};
    return add(Mat_VarCreate(name.c_str(), MAT_C_INT16, MAT_T_INT16, 2, size, values.data(), 0));
  }
  MatWriter& text(std::string const& name, std::string value) {
    std::size_t size[2] = {1, value.size()};
    return add(Mat_VarCreate(name.c_str(), MAT_C_CHAR, MAT_T_UINT8, 2, size, value.data(), 0));
  }
  // Adds a matrix of characters with one text per row. All texts must have the same length.
  MatWriter& texts(std::string const& name, std::vector<std::string> const& rows) {
    std::string columns;
    for (std::size_t k = 0; k < rows.front().size(); ++k)
      for (auto const& row : rows) columns += row[k];
    std::size_t size[2] = {rows.size(), rows.front().size()};
    return add(Mat_VarCreate(name.c_str(), MAT_C_CHAR, MAT_T_UINT8, 2, size, columns.data(), 0));
  }
  MatWriter& structure(std::string const& name, std::vector<Named> structs) {
    std::vector<char const*> names;
    for (auto const& [field, values] : structs.front()) names.push_back(field.c_str());
    std::size_t size[2] = {1, structs.size()};
    auto* owner = Mat_VarCreateStruct(name.c_str(), 2, size, names.data(), static_cast<unsigned>(names.size()));
    for (std::size_t i = 0; i < structs.size(); ++i)
      for (auto& [field, values] : structs[i])
        Mat_VarSetStructFieldByName(owner, field.c_str(), i, variable(nullptr, values, 1));
    return add(owner);
  }
  MatWriter& all(Named const& columns) {
    for (auto const& [name, values] : columns) array(name, values);
    return *this;
  }

 private:
  static matvar_t* variable(char const* name, std::vector<double>& values, std::size_t columns) {
    std::size_t size[2] = {values.size() / columns, columns};
    return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, size, values.data(), 0);
  }
  MatWriter& add(matvar_t* variable) {
    EXPECT_EQ(Mat_VarWrite(mat_, variable, compression_), 0);
    Mat_VarFree(variable);
    return *this;
  }

  std::filesystem::path file_;
  matio_compression compression_;
  mat_t* mat_;
};

}  // namespace isolaw::data::testing
