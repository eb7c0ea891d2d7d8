// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/io/obj_reader.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "geometry/io/mesh_builder.h"
#include "geometry/io/obj_lines.h"
#include "geometry/util/byte_text.h"
#include "geometry/util/messages.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

constexpr std::size_t kBytesPerVertex = 60;  // bytes of text, usually: an estimate for the first allocation

class ObjParser {
public:
    ObjParser(std::string_view text, std::string name, const Vec3& offset)
        : lines_(text), name_(std::move(name)), mesh_(text.size() / kBytesPerVertex + 2, offset) {}

    ReadAttempt parse() { return {parseLines(), mesh_.rounding()}; }

private:
    Expected<ReadMesh> parseLines() {
        for (std::string_view line; lines_.next(line);) {
            if (!parseLine(line)) {
                return unexpected(msg::kObjRefused, name_, lines_.number(), problem_);
            }
        }
        if (!mesh_.hasTriangles()) {
            return unexpected(msg::kObjNoFaces, name_);
        }
        ReadMesh read{mesh_.take()};
        if (unknownLines_ > 0) read.importNotes.push_back(onUnknownLines());
        return read;
    }

    bool parseLine(std::string_view line) {
        obj::Words words(line);
        const std::string_view keyword = words.next();
        switch (obj::keywordOf(keyword)) {
            case obj::Keyword::Vertex:
                return parseVertex(words);
            case obj::Keyword::Face:
                return parseFace(words);
            case obj::Keyword::Ignored:
                return true;
            case obj::Keyword::Unknown:
                break;
        }
        if (unknownLines_++ == 0) {
            firstUnknown_ = lines_.number();
            unknownWord_ = quotedWord(keyword);
        }
        return true;
    }

    bool parseVertex(obj::Words& words) {
        Vec3 position;
        for (double& coordinate : position) {
            const std::string_view word = words.next();
            const std::optional<double> value = toCoordinate(word);
            if (!value || !std::isfinite(static_cast<float>(*value)))
                return fail({msg::kObjCoordinateFound, quotedWord(word)});
            coordinate = *value;
        }
        return mesh_.addVertex(position) || fail(msg::kExpectedFinite);
    }

    bool parseFace(obj::Words& words) {
        mesh_.beginFace();
        for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
            const std::optional<std::size_t> vertex = vertexNamed(word.substr(0, word.find('/')));
            if (!vertex) return fail({msg::kObjVertexFound, quotedWord(word)});
            mesh_.addCorner(*vertex);
        }
        if (mesh_.corners() < 3) return fail(msg::kObjFewCorners);
        const MessageText* const problem = mesh_.endFace();
        return problem == nullptr || fail(*problem);
    }

    /// Numbers count from 1, negative ones back from the last vertex.
    std::optional<std::size_t> vertexNamed(std::string_view word) const {
        const std::optional<std::int64_t> number = toWholeNumber(word);
        const auto count = static_cast<std::int64_t>(mesh_.vertices());
        if (!number || *number == 0 || *number > count || *number < -count) return std::nullopt;
        return static_cast<std::size_t>(*number > 0 ? *number - 1 : count + *number);
    }

    static std::optional<std::int64_t> toWholeNumber(std::string_view word) {
        std::int64_t value = 0;
        const auto [stop, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (word.empty() || stop != word.data() + word.size() || failure != std::errc()) return std::nullopt;
        return value;
    }

    [[nodiscard]] ImportNote onUnknownLines() const {
        if (unknownLines_ == 1) {
            return {ImportNoteTopic::File, {msg::kNoteUnknownLine, name_, firstUnknown_, unknownWord_}};
        }
        return {ImportNoteTopic::File, {msg::kNoteUnknownLines, name_, unknownLines_, firstUnknown_, unknownWord_}};
    }

    bool fail(Message problem) {
        problem_ = std::move(problem);
        return false;
    }

    obj::Lines lines_;
    std::string name_;
    MeshBuilder mesh_;
    Message problem_;
    std::size_t unknownLines_ = 0, firstUnknown_ = 0;
    std::string unknownWord_;
};

}  // namespace

Expected<ReadMesh> parseObj(std::span<const std::byte> bytes, std::string_view name) {
    const std::string shown(name);
    return readWithOffset(shown, [&](const Vec3& offset) { return ObjParser(asText(bytes), shown, offset).parse(); });
}

}  // namespace tactooth
