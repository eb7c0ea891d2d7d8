// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace tactooth {

/// Reads the lines of a text one by one. A line ends in LF, CR LF, or CR alone (as on old Macs; some programs still
/// write it); a text may mix them. A byte order mark before the first line is skipped.
class TextLines {
public:
    explicit TextLines(std::string_view text) : text_(text), at_(text.starts_with("\xEF\xBB\xBF") ? 3 : 0) {
        lineFeed_ = text_.find('\n', at_);
        carriageReturn_ = text_.find('\r', at_);
    }

    /// Moves to the next line and returns it without its end; false after the last line.
    bool next(std::string_view& line) {
        if (at_ >= text_.size()) return false;
        const std::size_t end = std::min({lineFeed_, carriageReturn_, text_.size()});
        line = text_.substr(at_, end - at_);
        at_ = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
        // Each search starts where the last one ended, so that the whole text is searched once.
        if (lineFeed_ < at_) lineFeed_ = text_.find('\n', at_);
        if (carriageReturn_ < at_) carriageReturn_ = text_.find('\r', at_);
        ++number_;
        return true;
    }

    /// Number of the last line that was read; the first is 1.
    [[nodiscard]] std::size_t number() const { return number_; }

private:
    std::string_view text_;
    std::size_t at_;
    std::size_t lineFeed_ = 0, carriageReturn_ = 0;  ///< positions of the next line feed and carriage return
    std::size_t number_ = 0;
};

}  // namespace tactooth
