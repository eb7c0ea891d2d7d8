// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/util/expected.h"
#include "tooth/model/material_registry.h"
#include "view/camera/orbit_camera.h"

namespace tactooth {

// Parsers for the one-word values of the options of 'render'. The error is a sentence that quotes the value.

/// "1920x1080"
[[nodiscard]] Expected<ImageSize> parseSize(const std::string& text);

struct ViewArgument {
    std::optional<StandardView> standard;
    OrbitCamera::Direction free;  ///< used if `standard` is empty; for a tooth with +x mesial
};
/// Finds the view with a name of kStandardViews; null for any other name.
[[nodiscard]] const StandardView* standardView(std::string_view name);

/// A name of kStandardViews, "dentist", or "AZIMUTH,ELEVATION" in degrees.
[[nodiscard]] Expected<ViewArgument> parseView(const std::string& text);

/// "1.5,-2,7"
[[nodiscard]] Expected<Vec3> parsePoint(const std::string& text);

struct ClipArgument {
    StandardView side = StandardView::Buccal;
    double fromMiddle = 0;  ///< mm
};
/// "buccal" or "buccal=1.5"
[[nodiscard]] Expected<ClipArgument> parseClip(const std::string& text);

struct OpacityArgument {
    MaterialId material{};
    float opacity = 1;
};
/// "enamel=0.3"
[[nodiscard]] Expected<OpacityArgument> parseOpacity(const std::string& text, const MaterialRegistry& materials);

/// "turn.png" and 7 give "turn-007.png".
[[nodiscard]] std::filesystem::path numberedFile(const std::filesystem::path& file, int number);

}  // namespace tactooth
