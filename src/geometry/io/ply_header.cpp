// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/io/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "geometry/util/byte_text.h"
#include "geometry/util/messages.h"
#include "geometry/util/number_text.h"

namespace tactooth::ply {
namespace {

constexpr std::array<std::pair<std::string_view, Scalar>, 16> kScalars = {{{"char", Scalar::Int8},
                                                                           {"int8", Scalar::Int8},
                                                                           {"uchar", Scalar::UInt8},
                                                                           {"uint8", Scalar::UInt8},
                                                                           {"short", Scalar::Int16},
                                                                           {"int16", Scalar::Int16},
                                                                           {"ushort", Scalar::UInt16},
                                                                           {"uint16", Scalar::UInt16},
                                                                           {"int", Scalar::Int32},
                                                                           {"int32", Scalar::Int32},
                                                                           {"uint", Scalar::UInt32},
                                                                           {"uint32", Scalar::UInt32},
                                                                           {"float", Scalar::Float32},
                                                                           {"float32", Scalar::Float32},
                                                                           {"double", Scalar::Float64},
                                                                           {"float64", Scalar::Float64}}};

std::optional<Scalar> scalarNamed(std::string_view word) {
    for (const auto& [name, scalar] : kScalars) {
        if (word == name) return scalar;
    }
    return std::nullopt;
}

std::vector<std::string_view> wordsOf(std::string_view line) {
    constexpr std::string_view kBlank = " \t\r";
    std::vector<std::string_view> words;
    for (std::size_t begin = line.find_first_not_of(kBlank); begin != line.npos;) {
        const std::size_t end = std::min(line.find_first_of(kBlank, begin), line.size());
        words.push_back(line.substr(begin, end - begin));
        begin = line.find_first_not_of(kBlank, end);
    }
    return words;
}

/// The line end of a header: that of its first line. In a file whose lines end in CR only, a byte of the data may look
/// like LF.
char lineEndOf(std::string_view file) {
    const std::size_t first = file.find_first_of("\r\n");
    const bool isCarriageReturn = first != file.npos && file[first] == '\r' && file.substr(first, 2) != "\r\n";
    return isCarriageReturn ? '\r' : '\n';
}

class HeaderParser {
public:
    bool takeLine(const std::vector<std::string_view>& words) {
        if (words.empty() || words[0] == "ply" || words[0] == "comment" || words[0] == "obj_info") return true;
        if (words[0] == "format") return takeFormat(words);
        if (words[0] == "element") return takeElement(words);
        if (words[0] == "property") return takeProperty(words);
        return false;
    }

    Header header;
    bool hasFormat = false;

private:
    bool takeFormat(const std::vector<std::string_view>& words) {
        if (words.size() != 3 || words[2] != "1.0") return false;
        if (words[1] == "ascii") header.encoding = Encoding::Ascii;
        if (words[1] == "binary_little_endian") header.encoding = Encoding::LittleEndian;
        if (words[1] == "binary_big_endian") header.encoding = Encoding::BigEndian;
        hasFormat = words[1] == "ascii" || words[1] == "binary_little_endian" || words[1] == "binary_big_endian";
        return hasFormat;
    }

    bool takeElement(const std::vector<std::string_view>& words) {
        if (words.size() != 3) return false;
        Element element{std::string(words[1]), 0, {}};
        const char* const end = words[2].data() + words[2].size();
        const auto [stop, failure] = std::from_chars(words[2].data(), end, element.count);
        header.elements.push_back(std::move(element));
        return stop == end && failure == std::errc();
    }

    bool takeProperty(const std::vector<std::string_view>& words) {
        if (header.elements.empty() || words.size() < 3) return false;
        const bool isList = words[1] == "list";
        if (words.size() != (isList ? 5U : 3U)) return false;
        const auto type = scalarNamed(words[isList ? 3 : 1]);
        const auto countType = isList ? scalarNamed(words[2]) : std::nullopt;
        if (!type || (isList && (!countType || *countType >= Scalar::Float32))) return false;
        header.elements.back().properties.push_back({std::string(words.back()), *type, countType});
        return true;
    }
};

}  // namespace

std::size_t bytesOf(Scalar scalar) {
    constexpr std::array<std::size_t, 8> kBytes = {1, 1, 2, 2, 4, 4, 4, 8};
    return kBytes[static_cast<std::size_t>(scalar)];
}

bool looksLikePly(std::string_view file) {
    file = withoutByteOrderMark(file);
    return file.starts_with("ply\n") || file.starts_with("ply\r");
}

Expected<Header> parseHeader(std::string_view file, const std::string& name) {
    HeaderParser parser;
    std::size_t at = file.size() - withoutByteOrderMark(file).size();
    const char lineEnd = lineEndOf(file);
    for (std::size_t line = 1; at < file.size(); ++line) {
        const std::size_t end = std::min(file.find(lineEnd, at), file.size());
        const std::vector<std::string_view> words = wordsOf(file.substr(at, end - at));
        at = std::min(end + 1, file.size());
        if (words.size() == 1 && words[0] == "end_header") {
            if (!parser.hasFormat) return unexpected(msg::kPlyNoFormat, name);
            parser.header.bytes = at;
            parser.header.lines = line;
            return parser.header;
        }
        if (!parser.takeLine(words)) {
            return unexpected(msg::kPlyExpectedHeaderLine, name, line, quotedWord(words[0]));
        }
    }
    return unexpected(msg::kPlyNoHeaderEnd, name);
}

}  // namespace tactooth::ply
