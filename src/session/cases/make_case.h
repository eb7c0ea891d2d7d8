// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/expected.h"
#include "patient/scan_import.h"
#include "session/cases/case_description.h"
#include "session/cases/case_store.h"

namespace tactooth {

/// What a new case is made of.
struct CaseRequest {
    std::vector<std::filesystem::path> from = {};  ///< surfaces, or folders with surfaces
    std::string title = {};
    std::string licence = {};
    std::string provenance = {};
    std::optional<int> quadrant = {};  ///< 1..4: a name that ends in 1..8 is a tooth of this quarter of the mouth
    ImportChoices choices = {};
    std::vector<std::filesystem::path> burs = {};  ///< as readOwnBur takes them
    std::filesystem::path materials = {};
};

/// The surfaces of one tooth by the names of their files: "L6_enamel.stl" is the enamel of the tooth L6,
/// "L6_whole.stl", "L6_outer.stl" and "L6.stl" its outer surface; "mandible_cortical_bone.stl" and other names that end
/// in bone, jaw, gum or gingiva are what stands around.
struct NamedSurface {
    std::string body;                    ///< of the tooth, or of what is around
    std::optional<MaterialId> material;  ///< none: the outer surface
    bool isAround = false;
};
[[nodiscard]] NamedSurface surfaceNamed(const std::filesystem::path& file);

/// A case that has been made and not been written yet.
struct MadeCase {
    CaseDescription description;
    std::vector<CaseFile> files;  ///< with case.toml
};

/// Tells which body is being worked on; false: stop.
using CaseProgress = std::function<bool(const std::string& body, double part)>;

/// Imports the surfaces of one or several teeth. Several keep their places to each other; their cheeks look away from
/// the middle of their arch. Fails with one sentence.
[[nodiscard]] Expected<MadeCase> makeCase(const CaseRequest& request, const CaseProgress& progress = {});

/// A case of one tooth that was imported before.
[[nodiscard]] Expected<MadeCase> caseOf(const ExaminedScan& tooth, const CaseRequest& request);

/// Writes an archive if the name ends in .ttcase, else a folder, which must be new or empty.
[[nodiscard]] Expected<void> writeCase(const std::vector<CaseFile>& files, const std::filesystem::path& to);

}  // namespace tactooth
