// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/io/mesh_builder.h"
#include "geometry/io/stl_format.h"
#include "geometry/mesh/vertex_welder.h"
#include "geometry/util/byte_text.h"
#include "geometry/util/messages.h"
#include "geometry/util/number_text.h"

namespace tactooth::stl {
namespace {

bool isSpace(char letter) { return letter == ' ' || (letter >= '\t' && letter <= '\r'); }

bool sameWord(std::string_view word, std::string_view lowerCase) {
    return std::equal(word.begin(), word.end(), lowerCase.begin(), lowerCase.end(), [](char letter, char wanted) {
        return letter == wanted || (letter >= 'A' && letter <= 'Z' && (letter | 0x20) == wanted);
    });
}

/// Reads ASCII STL word by word and keeps the line number for messages.
class AsciiParser {
public:
    AsciiParser(std::string_view text, const std::string& name, const Vec3& offset)
        : at_(text.data()),
          end_(text.data() + text.size()),
          name_(name),
          rounding_(offset),
          welder_(text.size() / kBytesPerVertex + 2) {
        at_ += text.size() - withoutByteOrderMark(text).size();
        mesh_.triangles.reserve(text.size() / (2 * kBytesPerVertex) + 2);
    }

    ReadAttempt parse() { return {parseSolids(), rounding_}; }

private:
    Expected<ReadMesh> parseSolids() {
        while (nextWord()) {
            if (!sameWord(word_, "solid")) return refuse(msg::kStlExpectedSolid);
            if (!parseSolid()) return Unexpected{error_};
        }
        if (mesh_.triangles.empty()) return unexpected(msg::kNoTriangles, name_);
        mesh_.vertices = welder_.takeVertices();
        return ReadMesh{std::move(mesh_)};
    }

    /// A facet takes about 250 bytes of text, and a closed surface has two facets for each vertex: an estimate for the
    /// first allocation, in proportion to the size of the text.
    static constexpr std::size_t kBytesPerVertex = 500;

    /// Moves to the next word; false at the end of the text.
    bool nextWord() {
        for (; at_ != end_ && isSpace(*at_); ++at_) line_ += isLineEnd();
        const char* begin = at_;
        while (at_ != end_ && !isSpace(*at_)) ++at_;
        word_ = {begin, static_cast<std::size_t>(at_ - begin)};
        return begin != at_;
    }

    /// Whether a line ends here: in LF, or in CR without a following LF.
    [[nodiscard]] bool isLineEnd() const {
        return *at_ == '\n' || (*at_ == '\r' && (at_ + 1 == end_ || at_[1] != '\n'));
    }

    void skipLine() {
        while (at_ != end_ && *at_ != '\n' && *at_ != '\r') ++at_;
    }

    bool parseSolid() {
        skipLine();  // the rest of the line is the solid's name, which may be any text
        while (nextWord()) {
            if (sameWord(word_, "endsolid")) return skipLine(), true;
            if (!sameWord(word_, "facet")) return fail(msg::kStlExpectedFacet);
            if (!parseFacet()) return false;
        }
        return fail(msg::kStlExpectedFacet);
    }

    bool parseFacet() {
        if (!expectWord("normal")) return false;
        for (int axis = 0; axis < 3; ++axis) {  // ignored; some programs write words like 1.#QNAN here
            if (!nextWord()) return fail(msg::kStlExpectedNormal);
        }
        if (!expectWord("outer") || !expectWord("loop")) return false;
        Triangle triangle;
        for (std::uint32_t& vertex : triangle) {
            Vec3 position;
            if (!expectWord("vertex") || !parsePosition(position)) return false;
            const Vec3f rounded = rounding_.round(position);
            if (!rounded.allFinite()) return fail(msg::kExpectedFinite);
            vertex = welder_.add(rounded);
        }
        if (!expectWord("endloop") || !expectWord("endfacet")) return false;
        mesh_.triangles.push_back(triangle);
        return true;
    }

    bool parsePosition(Vec3& position) {
        for (double& coordinate : position) {
            const std::optional<double> value = nextWord() ? toCoordinate(word_) : std::nullopt;
            if (!value) return fail(msg::kStlExpectedCoordinate);
            if (!std::isfinite(static_cast<float>(*value))) return fail(msg::kExpectedFinite);
            coordinate = *value;
        }
        return true;
    }

    bool expectWord(const char* keyword) {
        if (nextWord() && sameWord(word_, keyword)) return true;
        return fail({msg::kStlExpectedWord, keyword});
    }

    bool fail(const Message& expectation) {
        const Message found = word_.empty() ? Message(msg::kFileEnds) : Message(msg::kFound, quotedWord(word_));
        error_ = {msg::kStlRefused, name_, line_, expectation, found};
        return false;
    }

    Unexpected refuse(const Message& expectation) {
        fail(expectation);
        return Unexpected{error_};
    }

    const char* at_;
    const char* end_;
    std::string_view word_;
    std::size_t line_ = 1;
    const std::string& name_;
    PositionRounding rounding_;
    VertexWelder welder_;
    TriangleMesh mesh_;
    Error error_;
};

}  // namespace

Expected<ReadMesh> parseAscii(std::string_view text, const std::string& name) {
    return readWithOffset(name, [&](const Vec3& offset) { return AsciiParser(text, name, offset).parse(); });
}

Expected<ReadMesh> parseAsciiInPlace(std::string_view text, const std::string& name) {
    return AsciiParser(text, name, Vec3::Zero()).parse().mesh;
}

}  // namespace tactooth::stl
