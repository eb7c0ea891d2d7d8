// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "session/cases/custom_bur.h"
#include "session/live/live_runner.h"

namespace tactooth {

/// A bur that is ready to cut, with its meshes for the picture.
struct SessionBur {
    std::string name;  ///< for people
    Instrument instrument;
    std::shared_ptr<const TriangleMesh> shown;
    std::shared_ptr<const TriangleMesh> blurred;  ///< spinEnvelopeMesh: the bur as the eye sees it turning fast
    BurMaterial material = BurMaterial::Carbide;
    std::filesystem::path file;  ///< that describes it; empty for a bur of the catalogue or of a case
};

// These take up to a second: run them in a Task. They fail with one sentence for the user.
[[nodiscard]] Expected<SessionBur> makeSessionBur(const BurSpec& spec);
/// `file`: that described `bur`; empty if a case brought it.
[[nodiscard]] Expected<SessionBur> makeSessionBur(CustomBur bur, const std::filesystem::path& file);
[[nodiscard]] Expected<SessionBur> loadSessionBur(const std::filesystem::path& path);

}  // namespace tactooth
