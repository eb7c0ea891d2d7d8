// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "tooth/model/material_registry.h"

namespace tactooth {

/// The meaning of a surface by the name of its file. "L6_enamel.stl" is the enamel of the tooth L6. "L6_whole.stl",
/// "L6_outer.stl" and "L6.stl" are its outer surface. Names that end in bone, jaw, gum or gingiva, as
/// "mandible_cortical_bone.stl", are bodies around the teeth.
struct NamedSurface {
    std::string body;                    ///< name of the tooth, or of the body around it
    std::optional<MaterialId> material;  ///< none: the outer surface
    bool isAdjacent = false;
};
[[nodiscard]] NamedSurface surfaceNamed(const std::filesystem::path& file,
                                        const MaterialRegistry& materials = builtinMaterials());

/// The FDI number at the end of a name: 36 for "T36", and for "L6" in quadrant 3. 0: none.
[[nodiscard]] int fdiNamed(const std::string& name, const std::optional<int>& quadrant);

/// Makes the names of files in a new case.
class EntryNames {
public:
    /// A name of letters, digits, '-' and '_', which every file system accepts. No name comes twice, even where the
    /// file system ignores capitals: "歯 1" and "歯-1" become "----1" and "----1-2".
    [[nodiscard]] std::string make(const std::string& name);

private:
    std::set<std::string> taken_;  // in small letters
};

/// Makes the names of teeth and of bodies around them in a new case.
class BodyNames {
public:
    /// The name of a file as valid UTF-8 without control characters and slashes, at most 60 bytes. No name comes twice:
    /// names that differ only in invalid bytes get a number.
    [[nodiscard]] std::string make(const std::string& name);

private:
    std::set<std::string> taken_;
};

}  // namespace tactooth
