// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "collision/bvh/surface.h"
#include "geometry/io/import_note.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// The visible surface of a tooth without its surroundings, as read from a file: equal positions are one vertex.
[[nodiscard]] TriangleMesh asReadFromFile(const Surface& tooth);

/// The ideal shape of a tooth, in the tooth's frame: from a surface (STL, OBJ, PLY), or from a saved tooth that an
/// expert has cut. Fails with one sentence.
[[nodiscard]] Expected<TriangleMesh> loadIdealShape(const std::filesystem::path& file,
                                                    std::vector<ImportNote>* importNotes = nullptr);

}  // namespace tactooth
