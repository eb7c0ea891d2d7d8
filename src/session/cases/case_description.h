// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/util/expected.h"
#include "geometry/util/pose.h"
#include "tooth/model/material_registry.h"

namespace tactooth {

/// One tooth of a case. File names are relative to the case's folder.
struct CaseTooth {
    std::string name;   ///< unique in the case
    int fdi = 0;        ///< FDI number; 0: unknown
    std::string outer;  ///< the surface that is touched, closed, mm, in the tooth frame
    std::vector<std::pair<MaterialId, std::string>> layers = {};
    MaterialId material{};    ///< of a tooth without layers
    bool isModelled = false;  ///< the layers are modelled, not measured
    Pose toothInCase = {};
    std::vector<std::string> assumed = {};  ///< assumptions about the surfaces, one sentence each
};

/// A body around the teeth (bone, gingiva). It can be touched and cut.
struct CaseSurrounding {
    std::string name;  ///< unique in the case
    std::string surface;
    MaterialId material{};
    Pose bodyInCase = {};
    std::vector<std::string> assumed = {};
};

/// The content of case.toml (docs/cases.md).
struct CaseDescription {
    std::string title;
    std::string licence;
    std::vector<std::string> provenance = {};
    std::string materials = {};  ///< a file like data/materials.toml; empty: the program's own
    const MaterialRegistry* registry = &builtinMaterials();  ///< the materials of that file
    std::vector<CaseTooth> teeth;
    std::vector<CaseSurrounding> around = {};
    std::vector<std::string> burs = {};  ///< files as readCustomBur takes them
};

/// Reads the file of a case's materials, which is named as in the case's folder.
using ReadCaseMaterials = std::function<Expected<const MaterialRegistry*>(const std::string& entry)>;

/// Reads case.toml; `name` stands for it in messages. Without `readMaterials` the case has the built-in materials.
/// Fails with one sentence with file and line.
[[nodiscard]] Expected<CaseDescription> parseCase(std::string_view text, std::string_view name,
                                                  const ReadCaseMaterials& readMaterials = {});

/// The text of case.toml; parseCase reads the same description from it.
[[nodiscard]] std::string caseText(const CaseDescription& description);

}  // namespace tactooth
