// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/io/import_note.h"
#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/expected.h"
#include "instruments/bur_catalogue.h"

namespace tactooth {

/// A bur of the user's own: a surface, and what a surface does not tell.
struct CustomBur {
    std::string name;
    TriangleMesh surface;  ///< mm, tip at the origin, +z along the shaft
    BurMaterial material = BurMaterial::Carbide;
    int flutes = 6;              ///< blades; 0 for a diamond
    double gritMicrometres = 0;  ///< of a diamond: mean grain
    double sharpness = 1;        ///< cutting ability: 1 as new, 0 does not cut

    [[nodiscard]] BurEdge edge() const { return {flutes, gritMicrometres}; }
};

/// Reads a file that lies beside the description, by its path relative to it.
using ReadSibling = std::function<Expected<std::vector<std::byte>>(const std::string&)>;

/// Reads a bur's description: TOML with name, surface, material (carbide or diamond), flutes, grit_um and sharpness.
/// `name` stands for the file in messages. `surface`, if the text names none. Fails with one sentence.
[[nodiscard]] Expected<CustomBur> parseCustomBur(std::string_view text, const std::string& name,
                                                 const ReadSibling& readSibling, const std::string& surface = {});

/// The description of a bur whose surface lies in the file `surface` beside it: parseCustomBur gives the same bur back,
/// but for digits that no hand feels.
[[nodiscard]] std::string customBurText(const CustomBur& bur, const std::string& surface);

/// A bur from its surface (STL, OBJ, PLY) or its description. A surface takes the description of the same name beside
/// it, "mine.toml" for "mine.stl", if there is one; without it is a sharp carbide bur.
[[nodiscard]] Expected<CustomBur> readCustomBur(const std::filesystem::path& path,
                                                std::vector<ImportNote>* importNotes = nullptr);

}  // namespace tactooth
