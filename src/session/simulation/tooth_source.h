// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "geometry/io/import_note.h"
#include "geometry/util/expected.h"
#include "session/simulation/cut_model.h"
#include "tooth/model/layered_tooth.h"

namespace tactooth {

/// The files of a tooth.
struct ToothSource {
    struct Layer {
        std::string material;  ///< its name
        std::filesystem::path file;

        bool operator==(const Layer&) const = default;
    };
    std::filesystem::path outer;                  ///< the surface that is touched
    std::vector<Layer> layers;                    ///< closed bodies inside it
    std::string material = {};                    ///< of the whole tooth, if there are no layers; empty: enamel
    const MaterialRegistry* materials = nullptr;  ///< null: those of a case, else the built-in ones

    bool operator==(const ToothSource&) const = default;
};

/// Parses "NAME=FILE.stl" of a command line.
[[nodiscard]] Expected<ToothSource::Layer> parseLayer(const std::string& text,
                                                      const MaterialRegistry& materials = builtinMaterials());

/// Fails with one sentence if a file cannot be read, a material is unknown or the surfaces make no tooth that can be
/// cut. Adds notes on the files and on repairs to `importNotes`, if given.
[[nodiscard]] Expected<std::shared_ptr<const LayeredTooth>> loadLayeredTooth(
    const ToothSource& source, std::vector<ImportNote>* importNotes = nullptr);

/// The envelope of revolution of a bur, and its sharpness.
[[nodiscard]] Expected<CuttingTool> makeCuttingTool(const TriangleMesh& bur, double sharpness = 1);

}  // namespace tactooth
