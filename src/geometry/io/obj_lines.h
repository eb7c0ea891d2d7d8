// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "geometry/util/text_lines.h"

namespace tactooth::obj {

inline constexpr std::string_view kBlank = " \t\f\v";

/// Reads the words of a line one by one.
class Words {
public:
    explicit Words(std::string_view line) : rest_(line) {}

    /// The next word; empty at the end of the line.
    std::string_view next() {
        const std::size_t begin = rest_.find_first_not_of(kBlank);
        if (begin == rest_.npos) return {};
        const std::size_t end = std::min(rest_.find_first_of(kBlank, begin), rest_.size());
        const std::string_view word = rest_.substr(begin, end - begin);
        rest_.remove_prefix(end);
        return word;
    }

private:
    std::string_view rest_;
};

/// The first word of a line.
enum class Keyword { Vertex, Face, Ignored, Unknown };

/// Ignored: what does not describe the surface (normals, texture, groups, materials, points, lines, comments). Unknown:
/// all else, and what describes a surface that is not supported, such as free-form curves.
[[nodiscard]] inline Keyword keywordOf(std::string_view word) {
    static constexpr std::array<std::string_view, 24> kIgnored = {
        "vn",     "vt",     "vp",         "g",         "o",     "s",     "mg",       "usemtl",
        "mtllib", "usemap", "maplib",     "l",         "p",     "bevel", "c_interp", "d_interp",
        "lod",    "cstype", "shadow_obj", "trace_obj", "ctech", "stech", "call",     "csh"};
    if (word == "v") return Keyword::Vertex;
    if (word == "f") return Keyword::Face;
    if (word.empty() || word.front() == '#') return Keyword::Ignored;
    return std::find(kIgnored.begin(), kIgnored.end(), word) != kIgnored.end() ? Keyword::Ignored : Keyword::Unknown;
}

/// Reads the lines of an OBJ file; a line that ends in a backslash continues in the next. Names and comments may end in
/// a backslash without continuing (a Windows folder does): only lines of numbers are joined.
class Lines {
public:
    explicit Lines(std::string_view text) : lines_(text) {}

    bool next(std::string_view& line) {
        if (!lines_.next(line)) return false;
        number_ = lines_.number();
        if (!continues(line) || !holdsNumbers(Words(line).next())) return true;
        joined_.clear();
        bool more = true;
        do {
            joined_.append(line.substr(0, line.rfind('\\'))) += ' ';
            more = lines_.next(line);
        } while (more && continues(line));
        if (more) joined_.append(line);
        line = joined_;
        return true;
    }

    /// Number of the last line, or of its first part.
    [[nodiscard]] std::size_t number() const { return number_; }

private:
    static bool continues(std::string_view line) {
        const std::size_t last = line.find_last_not_of(kBlank);
        return last != line.npos && line[last] == '\\';
    }
    static bool holdsNumbers(std::string_view keyword) {
        static constexpr std::array<std::string_view, 7> kOfNumbers = {"v", "f", "vn", "vt", "vp", "l", "p"};
        return std::find(kOfNumbers.begin(), kOfNumbers.end(), keyword) != kOfNumbers.end();
    }

    TextLines lines_;
    std::string joined_;
    std::size_t number_ = 0;
};

}  // namespace tactooth::obj
