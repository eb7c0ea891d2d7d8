// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/expected.h"
#include "session/cases/own_bur.h"
#include "session/work_piece.h"
#include "tooth/layered_tooth.h"

namespace tactooth {

/// Which files a tooth is made of.
struct ToothSource {
    struct Layer {
        std::string material;  ///< a name of MaterialId
        std::filesystem::path file;
    };
    std::filesystem::path outer;      ///< the surface that is touched, or a case
    std::vector<Layer> layers;        ///< what is inside, closed
    std::string material = "enamel";  ///< of the whole tooth, if there are no layers
    std::string workOn = {};          ///< the tooth of a case, by name or FDI number; empty: the first
};

/// Splits "NAME=FILE.stl" as it comes from a command line.
[[nodiscard]] Expected<ToothSource::Layer> parseLayer(const std::string& text);

/// A tooth from files, and how it stands.
struct PlacedTooth {
    std::shared_ptr<const LayeredTooth> tooth;    ///< of a case: all of it, in the frame of the one that is worked on
    Box3 box;                                     ///< of the tooth that is worked on, mm
    double mesialX = 1;                           ///< direction of mesial along x; a surface is taken to have it at +x
    std::string name;                             ///< for people
    std::optional<MaterialTable> materials = {};  ///< that a case brings
    std::optional<OwnBur> bur = {};               ///< that a case brings
    std::vector<std::pair<std::string, std::string>> provenance = {};
    std::vector<std::string> teethOfCase = {};  ///< names; empty: it is no case
};

/// Fails with one sentence if a file cannot be read, a material is unknown or the surfaces make no tooth that can be
/// cut. A case is loaded whole (docs/cases.md).
[[nodiscard]] Expected<PlacedTooth> loadPlacedTooth(const ToothSource& source);
[[nodiscard]] Expected<std::shared_ptr<const LayeredTooth>> loadLayeredTooth(const ToothSource& source);

/// What cutting needs to know of a bur: its envelope of revolution.
[[nodiscard]] Expected<CuttingTool> makeCuttingTool(const TriangleMesh& bur, double sharpness = 1);

}  // namespace tactooth
