// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/util/expected.h"
#include "patient/scan_import.h"
#include "session/cases/case_description.h"
#include "session/cases/case_store.h"

namespace tactooth {

/// The input of a new case.
struct CaseRequest {
    std::vector<std::filesystem::path> from = {};  ///< surfaces, or folders with surfaces
    std::string title = {};
    std::string licence = {};
    std::string provenance = {};
    std::optional<int> quadrant = {};  ///< 1..4: a name that ends in 1..8 is a tooth of this quarter of the mouth
    ImportOptions choices = {};
    std::vector<std::filesystem::path> burs = {};  ///< as findOrReadBur takes them
    std::filesystem::path materials = {};
};

/// A case that is not written yet.
struct NewCase {
    CaseDescription description;
    std::vector<CaseFile> files;  ///< with case.toml
    /// What `assumed` says in English, in every language: of each tooth, and of each body around them.
    std::vector<std::vector<Message>> ofTeeth, ofAround;
};

/// Called with the present body and its done part, 0..1. Return false to stop.
using CaseProgress = std::function<bool(const std::string& body, double part)>;

/// Imports the surfaces of one or several teeth. Several teeth keep their relative positions; buccal is away from the
/// middle of their arch. Fails with one sentence.
[[nodiscard]] Expected<NewCase> makeCase(const CaseRequest& request, const CaseProgress& progress = {});

/// A case of one imported tooth.
[[nodiscard]] Expected<NewCase> caseOf(const ExaminedScan& tooth, const CaseRequest& request);

}  // namespace tactooth
