// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/expected.h"

namespace tactooth::test {

/// A reader of bytes that nobody can vouch for.
struct FuzzTarget {
    const char* name;  ///< also that of the folder of its seeds, below corpus/
    /// Tries it with any bytes: true if it accepts them, and throws BrokenPromise if it does not do what it promises.
    bool (*accepts)(std::span<const std::byte>);
    /// Of seeds that are damaged once or twice, those that it takes all the same: so few at least, or the damage tries
    /// nothing but the first line.
    double leastAccepted = 0.05;
};

struct BrokenPromise : std::logic_error {
    using std::logic_error::logic_error;
};

/// Those that are linked into the program.
[[nodiscard]] inline std::vector<FuzzTarget>& fuzzTargets() {
    static std::vector<FuzzTarget> targets;
    return targets;
}

struct AddFuzzTarget {
    explicit AddFuzzTarget(const FuzzTarget& target) { fuzzTargets().push_back(target); }
};

inline void require(bool holds, const char* promise) {
    if (!holds) throw BrokenPromise(promise);
}

/// One sentence that begins with the name that the file was given.
inline void requireSentence(const Message& message, std::size_t longest = 400) {
    const std::string sentence = message.in(Language::English);
    require(sentence.starts_with("fuzz"), "a refusal names the file");
    require(sentence.ends_with('.') && sentence.size() > 20, "a refusal is a sentence");
    require(sentence.size() < longest, "a refusal is short");
    require(sentence.find('\n') == std::string::npos, "a refusal is one line");
}

inline void requireValid(const TriangleMesh& mesh) {
    for (const Vec3f& vertex : mesh.vertices) require(vertex.allFinite(), "coordinates are finite");
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) require(vertex < mesh.vertices.size(), "corners are vertices");
    }
}

[[nodiscard]] inline std::string_view asText(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace tactooth::test
