// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/io/ply_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include "geometry/io/mesh_builder.h"
#include "geometry/io/ply_header.h"
#include "geometry/util/byte_text.h"
#include "geometry/util/messages.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

using ply::Scalar;

template <class Number>
double numberFrom(std::array<char, 8> bytes) {
    Number value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return static_cast<double>(value);
}

/// Reads the numbers of the file's body one by one.
class Numbers {
public:
    Numbers(std::string_view body, ply::Encoding encoding) : rest_(body), encoding_(encoding) {}

    /// False at the end of the file, or where a word is not a number.
    bool next(Scalar type, double& value) {
        return encoding_ == ply::Encoding::Ascii ? nextWord(value) : nextBinary(type, value);
    }

    /// Largest count of numbers of a type that the rest of the file can hold.
    [[nodiscard]] std::uint64_t most(Scalar type) const {
        constexpr std::size_t kShortestWord = 2;  // a digit and a blank
        return rest_.size() / (encoding_ == ply::Encoding::Ascii ? kShortestWord : ply::bytesOf(type)) + 1;
    }

private:
    bool nextWord(double& value) {
        constexpr std::string_view kBlank = " \t\r\n";
        const std::size_t begin = rest_.find_first_not_of(kBlank);
        if (begin == rest_.npos) return false;
        const std::size_t end = std::min(rest_.find_first_of(kBlank, begin), rest_.size());
        const auto number = toNumber<double>(rest_.substr(begin, end - begin));
        rest_.remove_prefix(end);
        if (number) value = *number;
        return number.has_value();
    }

    bool nextBinary(Scalar type, double& value) {
        const std::size_t size = ply::bytesOf(type);
        if (rest_.size() < size) return false;
        std::array<char, 8> bytes{};
        const bool isReversed = encoding_ == ply::Encoding::BigEndian;
        for (std::size_t i = 0; i < size && i < bytes.size(); ++i) bytes[i] = rest_[isReversed ? size - 1 - i : i];
        rest_.remove_prefix(size);
        using Read = double (*)(std::array<char, 8>);
        constexpr std::array<Read, 8> kReads = {
            numberFrom<std::int8_t>,  numberFrom<std::uint8_t>,  numberFrom<std::int16_t>, numberFrom<std::uint16_t>,
            numberFrom<std::int32_t>, numberFrom<std::uint32_t>, numberFrom<float>,        numberFrom<double>};
        value = kReads[static_cast<std::size_t>(type)](bytes);
        return true;
    }

    std::string_view rest_;
    ply::Encoding encoding_;
};

static_assert(std::endian::native == std::endian::little, "numbers are put together as they lie in memory");

class PlyBody {
public:
    PlyBody(std::string_view file, const ply::Header& header, std::string name, const Vec3& offset)
        : numbers_(file.substr(header.bytes), header.encoding),
          header_(header),
          name_(std::move(name)),
          mesh_(kFirstVertices, offset) {}

    ReadAttempt read() { return {readElements(), mesh_.rounding()}; }

private:
    static constexpr std::size_t kFirstVertices = 1024;

    /// The meaning of a list of vertex numbers.
    enum class Corners { None, OfFace, OfStrips };

    Expected<ReadMesh> readElements() {
        for (const ply::Element& element : header_.elements) {
            if (element.properties.empty()) continue;  // takes no bytes, whatever its count
            for (std::uint64_t i = 0; i < element.count; ++i) {
                if (!readItem(element)) return refuse({msg::kPlyItemRefused, shown(element), i + 1, problem_});
            }
        }
        if (!mesh_.hasTriangles()) return refuse(msg::kPlyNoFaces);
        return ReadMesh{mesh_.take()};
    }

    static std::string shown(const ply::Element& element) {
        return element.name == "vertex" || element.name == "face" ? element.name : quotedWord(element.name);
    }

    static Corners cornersIn(const ply::Element& element, const ply::Property& property) {
        if (property.name != "vertex_indices" && property.name != "vertex_index") return Corners::None;
        if (element.name == "face") return Corners::OfFace;
        return element.name == "tristrips" ? Corners::OfStrips : Corners::None;
    }

    bool readItem(const ply::Element& element) {
        const bool isVertex = element.name == "vertex";
        Vec3 position = Vec3::Constant(std::nan(""));
        for (const ply::Property& property : element.properties) {
            if (property.countType) {
                if (!readList(property, cornersIn(element, property))) return false;
                continue;
            }
            double value = 0;
            if (!numbers_.next(property.type, value)) return fail(msg::kPlyNoNumber);
            const std::size_t axis = std::string_view("xyz").find(property.name);
            if (isVertex && property.name.size() == 1 && axis < 3) position[static_cast<int>(axis)] = value;
        }
        if (!isVertex || mesh_.addVertex(position)) return true;
        return fail(msg::kPlyNotFinite);
    }

    bool readList(const ply::Property& property, Corners corners) {
        double length = 0;
        if (!numbers_.next(*property.countType, length)) return fail(msg::kPlyCutShort);
        const bool isPossible = length >= 0 && length <= static_cast<double>(numbers_.most(property.type));
        if (!isPossible || length != std::floor(length)) return fail(msg::kPlyListTooLong);
        mesh_.beginFace();
        for (double left = length; left > 0; --left) {
            double value = 0;
            if (!numbers_.next(property.type, value)) return fail(msg::kPlyNoNumber);
            if (corners != Corners::None && !addCorner(value, corners)) return false;
        }
        if (corners == Corners::OfStrips) mesh_.endStrip();
        const MessageText* const problem = corners == Corners::OfFace ? mesh_.endFace() : nullptr;
        return problem == nullptr || fail(*problem);
    }

    bool addCorner(double value, Corners corners) {
        constexpr double kUnsignedMinusOne = 4294967295.0;
        if (corners == Corners::OfStrips && (value == -1 || value == kUnsignedMinusOne)) {
            mesh_.endStrip();
            return true;
        }
        const bool isVertex = value >= 0 && value < static_cast<double>(mesh_.vertices()) && value == std::floor(value);
        if (!isVertex) return fail(msg::kPlyNoVertex);
        mesh_.addCorner(static_cast<std::size_t>(value));
        return true;
    }

    bool fail(const MessageText& problem) {
        problem_ = problem;
        return false;
    }

    [[nodiscard]] Unexpected refuse(const Message& problem) const {
        return unexpected(msg::kPlyRefused, name_, problem);
    }

    Numbers numbers_;
    const ply::Header& header_;
    std::string name_;
    Message problem_;
    MeshBuilder mesh_;
};

}  // namespace

Expected<ReadMesh> parsePly(std::span<const std::byte> bytes, std::string_view name) {
    const std::string_view file = asText(bytes);
    const std::string shown(name);
    const Expected<ply::Header> header = ply::parseHeader(file, shown);
    if (!header) return Unexpected{header.error()};
    return readWithOffset(shown, [&](const Vec3& offset) { return PlyBody(file, *header, shown, offset).read(); });
}

}  // namespace tactooth
