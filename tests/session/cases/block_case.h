// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "geometry/stl_writer.h"
#include "session/cases/case_store.h"
#include "support/shapes.h"

namespace tactooth::test {

inline std::vector<std::byte> bytesOf(const std::string& text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

inline std::string textOf(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// A small case: two block teeth of enamel and dentin, 10 mm apart, on a plate of bone.
inline std::vector<CaseFile> blockCase() {
    const std::string text = R"(format = 1
title = "Two blocks"
licence = "CC0-1.0"
provenance = ["made for a test"]

[[tooth]]
name = "36"
fdi = 36
outer = "teeth/36/outer.stl"
layers = { enamel = "teeth/36/outer.stl", dentin = "teeth/36/dentin.stl" }
assumed = ["Units taken as mm."]

[[tooth]]
name = "37"
fdi = 37
outer = "teeth/36/outer.stl"
layers = { enamel = "teeth/36/outer.stl", dentin = "teeth/36/dentin.stl" }
position = [10.0, 0.0, 1.0]

[[around]]
name = "jaw bone"
surface = "bone.stl"
position = [0.0, 0.0, -12.0]
)";
    return {{"case.toml", bytesOf(text)},
            {"teeth/36/outer.stl", stlBytes(box(Vec3(-3, -3, -6), Vec3(3, 3, 4)))},
            {"teeth/36/dentin.stl", stlBytes(box(Vec3(-2, -2, -5), Vec3(2, 2, 2)))},
            {"bone.stl", stlBytes(box(Vec3(-10, -6, -2), Vec3(20, 6, 2)))}};
}

}  // namespace tactooth::test
