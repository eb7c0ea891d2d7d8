// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/bur_by_name.h"

#include "geometry/files/file_bytes.h"
#include "haptics/load_surface.h"
#include "instruments/bur_shape.h"
#include "session/cases/messages.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

/// Fails with a sentence about numbers and files if `name` is no file and does not look like one.
Expected<void> checkIsFile(const fs::path& name) {
    std::error_code unreadable;  // whoever reads the file reports that
    if (name.has_extension() || name.has_parent_path() || fs::exists(name, unreadable)) return {};
    return unexpected(msg::kNoSuchBur, displayName(name));
}

}  // namespace

Expected<CustomBur> findOrReadBur(const fs::path& numberOrFile, std::vector<ImportNote>* importNotes) {
    if (const auto spec = findBur(numberOrFile.native())) {
        return CustomBur{.name = spec->name,
                         .surface = makeBur(*spec).surface,
                         .material = spec->material,
                         .flutes = spec->flutes,
                         .gritMicrometres = spec->gritMicrometres,
                         .sharpness = spec->sharpness};
    }
    if (auto isFile = checkIsFile(numberOrFile); !isFile) return Unexpected{isFile.error()};
    return readCustomBur(numberOrFile, importNotes);
}

Expected<std::shared_ptr<const ToolShape>> findOrLoadTool(const fs::path& numberOrFile,
                                                          std::vector<ImportNote>* importNotes) {
    if (const auto spec = findBur(numberOrFile.native())) {
        return std::shared_ptr<const ToolShape>(std::make_shared<const ToolShape>(makeBur(*spec).surface));
    }
    if (auto isFile = checkIsFile(numberOrFile); !isFile) return Unexpected{isFile.error()};
    return loadTool(numberOrFile, importNotes);
}

}  // namespace tactooth
