// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/io/stl_writer.h"
#include "geometry/util/byte_text.h"
#include "session/cases/case_store.h"
#include "support/shapes.h"

namespace tactooth::test {

/// The text of one tooth in case.toml.
inline std::string blockTooth(int fdi, const std::string& more) {
    const std::string number = std::to_string(fdi);
    return "[[tooth]]\nname = \"" + number + "\"\nfdi = " + number + R"(
outer = "teeth/36/outer.stl"
layers = { enamel = "teeth/36/outer.stl", dentin = "teeth/36/dentin.stl" }
)" + more + "\n\n";
}

/// A small case: two block teeth of enamel and dentin, 10 mm apart, on a plate of bone.
inline std::vector<CaseFile> blockCase() {
    const std::string text = std::string(R"(format = 1
title = "Two blocks"
licence = "CC0-1.0"
provenance = ["made for a test"]

)") + blockTooth(36, "assumed = [\"Units taken as mm.\"]") +
                             blockTooth(37, "position = [10.0, 0.0, 1.0]") + R"([[around]]
name = "jaw bone"
surface = "bone.stl"
position = [0.0, 0.0, -12.0]
)";
    return {{"case.toml", bytesOf(text)},
            {"teeth/36/outer.stl", stlBytes(box(Vec3(-3, -3, -6), Vec3(3, 3, 4)))},
            {"teeth/36/dentin.stl", stlBytes(box(Vec3(-2, -2, -5), Vec3(2, 2, 2)))},
            {"bone.stl", stlBytes(box(Vec3(-10, -6, -2), Vec3(20, 6, 2)))}};
}

/// An archive with the given entry names, which no good program writes.
inline std::vector<std::byte> archiveWith(const std::string& name, const std::string& content = "x") {
    // The name has the same length as a safe one, which is then replaced in the bytes.
    std::string safe(name.size(), 'a');
    std::string bytes(asText(packCase({{safe, bytesOf(content)}}).value()));
    for (std::size_t at = bytes.find(safe); at != std::string::npos; at = bytes.find(safe, at + 1)) {
        bytes.replace(at, safe.size(), name);
    }
    return bytesOf(bytes);
}

}  // namespace tactooth::test
