// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/csv_fields.h"

#include <algorithm>

#include "geometry/util/lower_case.h"

namespace tactooth {

std::string_view trimmed(std::string_view text, std::string_view blanks) {
    const std::size_t first = text.find_first_not_of(blanks);
    return first == text.npos ? std::string_view{} : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

char namedSeparator(std::string_view line) {
    line = trimmed(line);
    if (line.size() > 1 && line.front() == '"' && line.back() == '"') line = line.substr(1, line.size() - 2);
    if (line == "sep=") return '\t';  // `trimmed` removed the tab
    const bool isNamed = line.size() == 5 && toLowerCase(std::string(line.substr(0, 4))) == "sep=";
    return isNamed && line[4] != '"' ? line[4] : '\0';
}

bool CsvFields::split(std::string_view line) {
    fields_.clear();
    unquoted_.clear();
    while (true) {
        if (const std::string_view begin = trimmed(line, blanks()); !begin.empty() && begin.front() == '"') {
            line = begin;
            if (!takeQuoted(line)) return false;
        } else {
            const std::size_t end = std::min(line.find(separator_), line.size());
            fields_.push_back(trimmed(line.substr(0, end), blanks()));
            line.remove_prefix(end);
        }
        if (line.empty()) return true;
        line.remove_prefix(1);  // the separator
    }
}

/// Reads the quoted cell at the start of `rest`; leaves `rest` at the separator behind it.
bool CsvFields::takeQuoted(std::string_view& rest) {
    std::size_t end = rest.find('"', 1);
    const bool isPlain = end != rest.npos && rest.substr(end + 1, 1) != "\"";
    if (isPlain) {
        fields_.push_back(trimmed(rest.substr(1, end - 1)));
    } else {
        std::string& text = unquoted_.emplace_back();
        for (std::size_t at = 1;; at = end + 2) {
            end = rest.find('"', at);
            if (end == rest.npos) return false;
            text.append(rest.substr(at, end - at));
            if (rest.substr(end + 1, 1) != "\"") break;
            text += '"';
        }
        fields_.push_back(trimmed(text));
    }
    rest.remove_prefix(end + 1);
    rest.remove_prefix(std::min(rest.find_first_not_of(blanks()), rest.size()));
    return rest.empty() || rest.front() == separator_;
}

}  // namespace tactooth
