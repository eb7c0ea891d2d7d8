// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/util/expected.h"

namespace tactooth::ply {

enum class Encoding { Ascii, LittleEndian, BigEndian };
enum class Scalar { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

[[nodiscard]] std::size_t bytesOf(Scalar scalar);

struct Property {
    std::string name;
    Scalar type = Scalar::Float32;
    std::optional<Scalar> countType;  ///< of a list: the type of its length
};

struct Element {
    std::string name;
    std::uint64_t count = 0;  ///< as the file claims
    std::vector<Property> properties;
};

struct Header {
    Encoding encoding = Encoding::Ascii;
    std::vector<Element> elements;
    std::size_t bytes = 0;  ///< length of the header, including a byte order mark before it: the data begin there
    std::size_t lines = 0;
};

[[nodiscard]] bool looksLikePly(std::string_view file);

/// Reads the header of a PLY file ("Polygon File Format", G. Turk 1994), whose lines end in LF, CR LF or CR. `name` is
/// the name of the file in messages.
[[nodiscard]] Expected<Header> parseHeader(std::string_view file, const std::string& name);

}  // namespace tactooth::ply
