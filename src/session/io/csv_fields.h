// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tactooth {

/// The cells of one line of a CSV file after the other. A cell may stand in quotes (RFC 4180), with separators inside
/// and doubled quotes for single ones; blanks around a cell do not count.
class CsvFields {
public:
    /// Between cells; a comma unless the file says otherwise.
    void separateBy(char separator) { separator_ = separator; }

    /// Cuts `line`, which stays where it is as long as the cells. False if a quote is opened that nothing closes, or if
    /// more follows a closed one within its cell.
    [[nodiscard]] bool split(std::string_view line);

    [[nodiscard]] std::span<const std::string_view> all() const { return fields_; }

private:
    [[nodiscard]] bool takeQuoted(std::string_view& rest);
    /// What does not count around a cell: a tab may be the separator.
    [[nodiscard]] std::string_view blanks() const { return separator_ == '\t' ? " " : " \t"; }

    char separator_ = ',';
    std::vector<std::string_view> fields_;
    std::deque<std::string> unquoted_;  ///< cells with quotes inside, where fields_ looks
};

/// Without the blanks (spaces and tabs, or those named) at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text, std::string_view blanks = " \t");

/// What a first line like `sep=;` says, with which a spreadsheet program names the separator; '\0' for another line.
[[nodiscard]] char namedSeparator(std::string_view line);

}  // namespace tactooth
