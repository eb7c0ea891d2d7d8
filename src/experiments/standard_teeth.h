// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/expected.h"
#include "tooth/model/layered_tooth.h"

namespace tactooth {

/// The teeth of the measurements.
enum class StandardToothKind {
    Front,
    Molar,
    Canine,  ///< canine
    Large    ///< of 325,312 triangles, as many as the largest published tooth has
};
inline constexpr std::array kStandardTeeth = {StandardToothKind::Front, StandardToothKind::Molar,
                                              StandardToothKind::Canine, StandardToothKind::Large};

struct StandardTooth {
    std::string name;    ///< "front tooth"
    std::string source;  ///< file in the folder of real teeth, or "built in: ..."
    TriangleMesh mesh;   ///< closed, crown up (+z) if it stands in its jaw
};

/// The folder with the real teeth of the project: $TACTOOTH_DATA, or ../shared/data from where the program was started.
[[nodiscard]] std::optional<std::filesystem::path> realTeethFolder();

/// A real tooth if its file is there, else a built-in one.
[[nodiscard]] Expected<StandardTooth> standardTooth(StandardToothKind kind);

/// A tooth of the user in place of a standard one.
[[nodiscard]] Expected<StandardTooth> customTooth(const std::filesystem::path& file);

/// An uncut tooth of one material with that surface. Fails with one sentence that names the source.
[[nodiscard]] Expected<std::shared_ptr<const LayeredTooth>> uncut(const StandardTooth& tooth);

/// The round bur of 336 triangles that measurements use.
[[nodiscard]] TriangleMesh standardBur();

/// Shares of a tooth's triangles that the resolution ladder keeps, percent.
inline constexpr std::array kResolutions = {6, 12, 25, 50, 100};

struct Resolution {
    int percent;
    TriangleMesh mesh;
};

/// The tooth at the given shares of its triangles (percent, rising, the last may be 100), each simplified from the next
/// finer one.
[[nodiscard]] std::vector<Resolution> resolutionLadder(const TriangleMesh& tooth, std::span<const int> percents);

}  // namespace tactooth
