// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "tooth/model/material_registry.h"

namespace tactooth {

/// The surfaces of one tooth by the names of their files: "L6_enamel.stl" is the enamel of the tooth L6,
/// "L6_whole.stl", "L6_outer.stl" and "L6.stl" its outer surface; "mandible_cortical_bone.stl" and other names that end
/// in bone, jaw, gum or gingiva are what stands around.
struct NamedSurface {
    std::string body;                    ///< of the tooth, or of what is around
    std::optional<MaterialId> material;  ///< none: the outer surface
    bool isAdjacent = false;
};
[[nodiscard]] NamedSurface surfaceNamed(const std::filesystem::path& file,
                                        const MaterialRegistry& materials = builtinMaterials());

/// The number of the tooth that a name ends in: "T36" is 36; in the quadrant 3, "L6" is 36 too. 0: none.
[[nodiscard]] int fdiNamed(const std::string& name, const std::optional<int>& quadrant);

/// Names of files in a new case.
class EntryNames {
public:
    /// Letters, digits, '-' and '_' alone, as every file system takes them, not too long, and no name twice, even where
    /// capitals do not count: "歯 1" and "歯-1" become "----1" and "----1-2".
    [[nodiscard]] std::string make(const std::string& name);

private:
    std::set<std::string> taken_;  // in small letters
};

/// Names of teeth, and of what is around them, in a new case.
class BodyNames {
public:
    /// The name of a file as text that case.toml takes: valid UTF-8 without control characters and slashes, at most 60
    /// bytes, and no name twice: files whose names are no UTF-8 may differ in what cannot be written.
    [[nodiscard]] std::string make(const std::string& name);

private:
    std::set<std::string> taken_;
};

}  // namespace tactooth
