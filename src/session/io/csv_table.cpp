// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/csv_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "geometry/files/file_bytes.h"
#include "geometry/util/assert.h"
#include "geometry/util/byte_text.h"
#include "geometry/util/lower_case.h"
#include "geometry/util/messages.h"
#include "geometry/util/number_text.h"
#include "geometry/util/text_lines.h"
#include "session/io/csv_fields.h"
#include "session/io/messages.h"

namespace tactooth {
namespace {

constexpr std::size_t kMaxCsvBytes = std::size_t{1} << 28;  // an hour at 1 kHz, in short numbers
std::string joined(std::span<const std::string_view> words) {
    std::string result;
    for (const std::string_view word : words) result.append(result.empty() ? "" : ",").append(word);
    return result;
}

/// The cells of a line, shortened for a message.
std::string shown(std::span<const std::string_view> cells) {
    std::string line;
    for (const std::string_view cell : cells) line.append(line.empty() ? "" : ",").append(cell);
    return quotedWord(line);
}

}  // namespace

/// Reads a CSV text line by line, with positions for messages.
class CsvParser {
public:
    CsvParser(std::string_view text, std::string_view name, std::span<const std::string_view> columns,
              std::span<const std::string_view> wordColumns)
        : text_(text), lines_(text), columns_(columns.begin(), columns.end()) {
        columns_.insert(columns_.end(), wordColumns.begin(), wordColumns.end());
        table_.name_ = name;
        table_.columns_ = columns.size();
        table_.wordColumns_ = wordColumns.size();
    }

    Expected<CsvTable> parse() {
        if (isWideText(text_)) return unexpected(msg::kTextInUtf16, table_.name_);
        if (!nextLine() && error_) return Unexpected{*error_};
        if (cells_.all().empty()) return unexpected(msg::kCsvNoHeader, table_.name_, joined(columns_));
        if (!parseHeader()) return Unexpected{*error_};
        while (nextLine()) {
            if (!parseRow()) return Unexpected{*error_};
        }
        if (error_) return Unexpected{*error_};
        if (table_.rows() == 0) return unexpected(msg::kCsvNoRows, table_.name_);
        return std::move(table_);
    }

private:
    /// Moves to the next line that is neither empty nor a comment and splits it; false at the end, or after an error.
    bool nextLine() {
        for (std::string_view line; lines_.next(line);) {
            if (const char separator = lines_.number() == 1 ? namedSeparator(line) : '\0'; separator != '\0') {
                cells_.separateBy(separator);
                continue;
            }
            const std::string_view begin = trimmed(line);
            if (begin.empty() || begin.front() == '#') continue;
            if (cells_.split(line)) return true;
            fail(msg::kCsvQuotes);
            return false;
        }
        return false;
    }

    /// Index of a column in the file, at or behind `from`; size() if it is missing. Ignores capitals unless a column
    /// matches exactly.
    std::size_t find(std::string_view column, std::size_t from) const {
        const auto cells = cells_.all();
        const auto isSame = [&](std::string_view cell) { return toLowerCase(std::string(cell)) == column; };
        if (std::ranges::find(cells, column) != cells.end())
            return static_cast<std::size_t>(
                std::find(cells.begin() + static_cast<std::ptrdiff_t>(from), cells.end(), column) - cells.begin());
        return static_cast<std::size_t>(
            std::find_if(cells.begin() + static_cast<std::ptrdiff_t>(from), cells.end(), isSame) - cells.begin());
    }

    bool parseHeader() {
        for (const std::string_view column : columns_) {
            const std::size_t found = find(column, 0);
            if (found == cells_.all().size()) {
                return fail({msg::kCsvColumnMissing, column, joined(columns_), shown(cells_.all())});
            }
            if (find(column, found + 1) != cells_.all().size()) {
                return fail({msg::kCsvColumnTwice, column});
            }
            positions_.push_back(found);
        }
        width_ = cells_.all().size();
        return true;
    }

    bool parseRow() {
        if (cells_.all().size() != width_) {
            return fail({msg::kCsvFields, width_, cells_.all().size()});
        }
        for (std::size_t column = 0; column < columns_.size(); ++column) {
            const std::string_view field = cells_.all()[positions_[column]];
            if (column >= table_.columns_) {
                table_.words_.emplace_back(field);
                continue;
            }
            const std::optional<double> value = toNumber<double>(field);
            if (!value || !std::isfinite(*value)) {
                return fail({msg::kCsvNumber, columns_[column], quotedWord(field)});
            }
            table_.values_.push_back(*value);
        }
        table_.lines_.push_back(lines_.number());
        return true;
    }

    bool fail(const Message& what) {
        error_ = Error{msg::kAtLine, table_.name_, lines_.number(), what};
        return false;
    }

    std::string_view text_;
    TextLines lines_;
    CsvFields cells_;
    std::vector<std::string_view> columns_;  ///< numbers first, then words
    std::vector<std::size_t> positions_;     ///< of each wanted column among the fields
    std::size_t width_ = 0;
    CsvTable table_;
    std::optional<Error> error_;
};

Message CsvTable::where(std::size_t row) const { return {msg::kCsvLine, name_, lines_[row]}; }

Expected<CsvTable> parseCsv(std::string_view text, std::string_view name, std::span<const std::string_view> columns,
                            std::span<const std::string_view> wordColumns) {
    return CsvParser(text, name, columns, wordColumns).parse();
}

Expected<CsvTable> readCsv(const std::filesystem::path& path, std::span<const std::string_view> columns,
                           std::span<const std::string_view> wordColumns) {
    const Expected<FileBytes> file = readFile(path, kMaxCsvBytes);
    if (!file) return Unexpected{file.error()};
    return parseCsv(file->text(), displayName(path), columns, wordColumns);
}

Expected<CsvWriter> CsvWriter::create(const std::filesystem::path& path, std::span<const std::string_view> columns) {
    Expected<AtomicFile> file = AtomicFile::create(path);
    if (!file) return Unexpected{file.error()};
    file->write(joined(columns) + "\n");
    return CsvWriter(std::move(*file), columns.size());
}

void CsvWriter::row(std::span<const double> values) {
    TACTOOTH_ASSERT(values.size() == columns_);
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
    return unexpected(msg::kCsvNotFinite, firstBadRow_);
}

}  // namespace tactooth
