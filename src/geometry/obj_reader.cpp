// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/obj_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/byte_text.h"
#include "geometry/number_text.h"
#include "geometry/vertex_welder.h"

namespace tactooth {
namespace {

constexpr std::size_t kBytesPerVertex = 60;  // of text, usually: an estimate for the first allocation
constexpr std::string_view kBlank = " \t\r\f\v";

/// The words of a line, one after the other.
class Words {
public:
    explicit Words(std::string_view line) : rest_(line) {}

    /// The next word; empty at the line's end.
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

class ObjParser {
public:
    ObjParser(std::string_view text, std::string_view name)
        : text_(text), name_(name), welder_(text.size() / kBytesPerVertex + 2) {}

    Expected<TriangleMesh> parse() {
        for (std::size_t line = 1; !text_.empty(); ++line) {
            if (!parseLine(Words(nextLine()))) {
                return unexpected(name_ + ", line " + std::to_string(line) + ": " + problem_ +
                                  "; repair or export the surface again.");
            }
        }
        if (mesh_.triangles.empty()) {
            return unexpected(name_ + ": the file holds no faces; export the surface again, as triangles.");
        }
        mesh_.vertices = welder_.takeVertices();
        return std::move(mesh_);
    }

private:
    std::string_view nextLine() {
        const std::size_t end = std::min(text_.find('\n'), text_.size());
        const std::string_view line = text_.substr(0, end);
        text_.remove_prefix(std::min(end + 1, text_.size()));
        return line;
    }

    bool parseLine(Words words) {
        const std::string_view keyword = words.next();
        if (keyword == "v") return parseVertex(words);
        if (keyword == "f") return parseFace(words);
        return true;
    }

    bool parseVertex(Words& words) {
        Vec3f position;
        for (float& coordinate : position) {
            const std::string_view word = words.next();
            const std::optional<float> value = toNumber<float>(word);
            if (!value || !std::isfinite(*value)) return fail("expected a finite coordinate, but found ", word);
            coordinate = *value;
        }
        vertices_.push_back(welder_.add(position));
        return true;
    }

    bool parseFace(Words& words) {
        std::vector<std::uint32_t>& corners = corners_;
        corners.clear();
        for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
            const std::optional<std::uint32_t> vertex = vertexNamed(word.substr(0, word.find('/')));
            if (!vertex) return fail("expected the number of a vertex that the file has given above, but found ", word);
            corners.push_back(*vertex);
        }
        if (corners.size() < 3) return fail("expected a face of three corners or more", {});
        for (std::size_t i = 2; i < corners.size(); ++i) {
            mesh_.triangles.push_back({corners[0], corners[i - 1], corners[i]});
        }
        return true;
    }

    /// Numbers count from 1, negative ones from the last vertex back.
    std::optional<std::uint32_t> vertexNamed(std::string_view word) const {
        const std::optional<std::int64_t> number = toWholeNumber(word);
        const auto count = static_cast<std::int64_t>(vertices_.size());
        if (!number || *number == 0 || *number > count || *number < -count) return std::nullopt;
        return vertices_[static_cast<std::size_t>(*number > 0 ? *number - 1 : count + *number)];
    }

    static std::optional<std::int64_t> toWholeNumber(std::string_view word) {
        std::int64_t value = 0;
        const auto [stop, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (word.empty() || stop != word.data() + word.size() || failure != std::errc()) return std::nullopt;
        return value;
    }

    bool fail(const char* expectation, std::string_view word) {
        problem_ = expectation;
        if (!word.empty()) problem_ += quotedWord(word);
        return false;
    }

    std::string_view text_;
    std::string name_;
    VertexWelder welder_;
    std::vector<std::uint32_t> vertices_;  ///< of the file, as welded
    std::vector<std::uint32_t> corners_;   ///< of the face at hand
    TriangleMesh mesh_;
    std::string problem_;
};

}  // namespace

Expected<TriangleMesh> parseObj(std::span<const std::byte> bytes, std::string_view name) {
    return ObjParser(asText(bytes), name).parse();
}

}  // namespace tactooth
