// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tactooth {

/// Splits lines of a CSV file into cells. A cell may stand in quotes (RFC 4180), with separators inside and doubled
/// quotes for single ones. Blanks around a cell do not count.
class CsvFields {
public:
    /// Sets the separator between cells; it is a comma at first.
    void separateBy(char separator) { separator_ = separator; }

    /// Splits `line`. The cells are views of it, so it must outlive them. Returns false if a quote is not closed, or if
    /// text follows a closed quote within its cell.
    [[nodiscard]] bool split(std::string_view line);

    [[nodiscard]] std::span<const std::string_view> all() const { return fields_; }

private:
    [[nodiscard]] bool takeQuoted(std::string_view& rest);
    /// The blanks around a cell: without the tab where that is the separator.
    [[nodiscard]] std::string_view blanks() const { return separator_ == '\t' ? " " : " \t"; }

    char separator_ = ',';
    std::vector<std::string_view> fields_;
    std::deque<std::string> unquoted_;  ///< cells with quotes inside; fields_ refers to them
};

/// Removes the blanks (spaces and tabs, or those given) at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text, std::string_view blanks = " \t");

/// The separator that a first line like `sep=;` of a spreadsheet program names; '\0' for another line.
[[nodiscard]] char namedSeparator(std::string_view line);

}  // namespace tactooth
