// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/csv_table.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <optional>

#include "geometry/file_bytes.h"
#include "geometry/number_text.h"

namespace tactooth {
namespace {

constexpr std::size_t kMostCsvBytes = std::size_t{1} << 28;  // an hour at 1 kHz, in short numbers
constexpr std::string_view kBlanks = " \t\r";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kBlanks);
    return first == text.npos ? std::string_view{} : text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// Cuts `line` at its commas, into `fields` (reused from line to line).
void split(std::string_view line, std::vector<std::string_view>& fields) {
    fields.clear();
    for (std::size_t comma = line.find(','); comma != line.npos; comma = line.find(',')) {
        fields.push_back(trimmed(line.substr(0, comma)));
        line.remove_prefix(comma + 1);
    }
    fields.push_back(trimmed(line));
}

std::string joined(std::span<const std::string_view> words) {
    std::string result;
    for (const std::string_view word : words) result.append(result.empty() ? "" : ",").append(word);
    return result;
}

}  // namespace

/// Reads a CSV text line by line and remembers where it is for messages.
class CsvParser {
public:
    CsvParser(std::string_view text, std::string_view name, std::span<const std::string_view> columns,
              std::span<const std::string_view> wordColumns)
        : rest_(text), columns_(columns.begin(), columns.end()) {
        columns_.insert(columns_.end(), wordColumns.begin(), wordColumns.end());
        if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);  // byte order mark of a spreadsheet program
        table_.name_ = name;
        table_.columns_ = columns.size();
        table_.wordColumns_ = wordColumns.size();
    }

    Expected<CsvTable> parse() {
        if (!nextLine())
            return unexpected(table_.name_ + ": there is no line that names the columns; begin the file with " +
                              joined(columns_) + ".");
        if (!parseHeader()) return Unexpected{error_};
        while (nextLine()) {
            if (!parseRow()) return Unexpected{error_};
        }
        if (table_.rows() == 0)
            return unexpected(table_.name_ + ": there are no rows below the names of the columns; add at least one.");
        return std::move(table_);
    }

private:
    /// Moves to the next line that is neither empty nor a comment and splits it; false at the end.
    bool nextLine() {
        while (!rest_.empty()) {
            const std::size_t end = std::min(rest_.find('\n'), rest_.size());
            const std::string_view line = trimmed(rest_.substr(0, end));
            rest_.remove_prefix(std::min(end + 1, rest_.size()));
            ++line_;
            if (line.empty() || line.front() == '#') continue;
            split(line, fields_);
            return true;
        }
        return false;
    }

    bool parseHeader() {
        for (const std::string_view column : columns_) {
            const auto found = std::find(fields_.begin(), fields_.end(), column);
            if (found == fields_.end()) {
                return fail("the column '" + std::string(column) + "' is missing; expected the columns " +
                            joined(columns_) + ", separated by commas");
            }
            if (std::find(found + 1, fields_.end(), column) != fields_.end()) {
                return fail("the column '" + std::string(column) + "' is named twice; remove one of the two");
            }
            positions_.push_back(static_cast<std::size_t>(found - fields_.begin()));
        }
        width_ = fields_.size();
        return true;
    }

    bool parseRow() {
        if (fields_.size() != width_) {
            return fail("expected " + std::to_string(width_) + " fields, one for each named column, but found " +
                        std::to_string(fields_.size()));
        }
        for (std::size_t column = 0; column < columns_.size(); ++column) {
            const std::string_view field = fields_[positions_[column]];
            if (column >= table_.columns_) {
                table_.words_.emplace_back(field);
                continue;
            }
            const std::optional<double> value = toNumber<double>(field);
            if (!value || !std::isfinite(*value)) {
                return fail("column '" + std::string(columns_[column]) +
                            "': expected a finite number with '.' as decimal point, but found " + quotedWord(field));
            }
            table_.values_.push_back(*value);
        }
        table_.lines_.push_back(line_);
        return true;
    }

    bool fail(const std::string& what) {
        error_ = {table_.name_ + ", line " + std::to_string(line_) + ": " + what + "."};
        return false;
    }

    std::string_view rest_;
    std::vector<std::string_view> columns_;  ///< numbers first, then words
    std::vector<std::string_view> fields_;
    std::vector<std::size_t> positions_;  ///< of each wanted column among the fields
    std::size_t width_ = 0;
    std::size_t line_ = 0;
    CsvTable table_;
    Error error_;
};

std::string CsvTable::where(std::size_t row) const { return name_ + ", line " + std::to_string(lines_[row]); }

Expected<CsvTable> parseCsv(std::string_view text, std::string_view name, std::span<const std::string_view> columns,
                            std::span<const std::string_view> wordColumns) {
    return CsvParser(text, name, columns, wordColumns).parse();
}

Expected<CsvTable> readCsv(const std::filesystem::path& path, std::span<const std::string_view> columns,
                           std::span<const std::string_view> wordColumns) {
    const Expected<FileBytes> file = readFile(path, kMostCsvBytes);
    if (!file) return Unexpected{file.error()};
    return parseCsv(file->text(), shownName(path), columns, wordColumns);
}

Expected<CsvWriter> CsvWriter::create(const std::filesystem::path& path, std::span<const std::string_view> columns) {
    Expected<AtomicFile> file = AtomicFile::create(path);
    if (!file) return Unexpected{file.error()};
    file->write(joined(columns) + "\n");
    return CsvWriter(std::move(*file), columns.size());
}

void CsvWriter::row(std::span<const double> values) {
    assert(values.size() == columns_);
    line_.clear();
    ++rows_;
    for (const double value : values) {
        if (!std::isfinite(value) && firstBadRow_ == 0) firstBadRow_ = rows_;
        std::array<char, 32> digits;  // the longest double takes 24
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
        line_.append(line_.empty() ? "" : ",").append(digits.data(), end);
    }
    line_ += '\n';
    file_.write(line_);
}

Expected<void> CsvWriter::commit() {
    if (firstBadRow_ == 0) return file_.commit();
    return unexpected("row " + std::to_string(firstBadRow_) +
                      " of the table has a number that is not finite, so nothing is written; check size and unit of "
                      "the surfaces.");
}

}  // namespace tactooth
