// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/files/atomic_file.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// The numbers and words of a CSV file: the requested columns, in the order of the request.
class CsvTable {
public:
    [[nodiscard]] std::size_t rows() const { return lines_.size(); }
    /// Finite. `column` counts in the order of the request.
    [[nodiscard]] double at(std::size_t row, std::size_t column) const { return values_[row * columns_ + column]; }
    [[nodiscard]] std::span<const double> row(std::size_t row) const {
        return std::span(values_).subspan(row * columns_, columns_);
    }
    /// In a column of words. `column` counts in the order of the request for words.
    [[nodiscard]] const std::string& wordAt(std::size_t row, std::size_t column) const {
        return words_[row * wordColumns_ + column];
    }
    /// The position of a row, to begin a message with: "poses.csv, line 12".
    [[nodiscard]] Message where(std::size_t row) const;

private:
    friend class CsvParser;

    std::string name_;
    std::size_t columns_ = 0;
    std::size_t wordColumns_ = 0;
    std::vector<double> values_;
    std::vector<std::string> words_;
    std::vector<std::size_t> lines_;  ///< of each row in the file, the first line is 1
};

/// Reads `columns` of a CSV file whose first line names its columns, in small letters or capitals. Commas separate the
/// cells, or the separator that a first line like `sep=;` names; cells may stand in quotes. The reader skips blanks
/// around cells, a byte order mark, empty lines and lines that begin with '#', and accepts any line ending. The decimal
/// point is '.' in every locale. Other columns are ignored. `wordColumns` are read as they are written.
///
/// Fails with one sentence with file and line: no header or no row, a column missing or named twice, too few or too
/// many fields, a quote that is not closed, a field that is not a finite number.
[[nodiscard]] Expected<CsvTable> readCsv(const std::filesystem::path& path, std::span<const std::string_view> columns,
                                         std::span<const std::string_view> wordColumns = {});

/// The same from memory; `name` stands for the file in messages.
[[nodiscard]] Expected<CsvTable> parseCsv(std::string_view text, std::string_view name,
                                          std::span<const std::string_view> columns,
                                          std::span<const std::string_view> wordColumns = {});

/// Writes a CSV file that appears under its name when it is complete (see AtomicFile). Numbers are written in the
/// shortest form that reads back as the same double.
class CsvWriter {
public:
    [[nodiscard]] static Expected<CsvWriter> create(const std::filesystem::path& path,
                                                    std::span<const std::string_view> columns);

    /// `values` holds one number a column.
    void row(std::span<const double> values);

    /// Gives the file its name. Call it once, after the last row. Fails and leaves no file if a number was not finite.
    [[nodiscard]] Expected<void> commit();

private:
    CsvWriter(AtomicFile file, std::size_t columns) : file_(std::move(file)), columns_(columns) {}

    AtomicFile file_;
    std::size_t columns_;
    std::string line_;
    std::size_t rows_ = 0;
    std::size_t firstBadRow_ = 0;  ///< with a number that is not finite; counted from 1
};

}  // namespace tactooth
