// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "collision/solid/solid.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// Makes a solid of `mesh`, which was read from `name`. Fails with one sentence, whose subject is `what` ("the surface
/// of the tooth"). `importNotes`, if given, gets the repairs.
[[nodiscard]] Expected<TriangleMesh> solidFrom(TriangleMesh mesh, const std::string& name, const Message& what,
                                               const SolidOptions& options = {},
                                               std::vector<ImportNote>* importNotes = nullptr);

/// The same for a mesh file. Also fails if the file cannot be read.
[[nodiscard]] Expected<TriangleMesh> loadSolid(const std::filesystem::path& file, const Message& what,
                                               const SolidOptions& options = {},
                                               std::vector<ImportNote>* importNotes = nullptr);

}  // namespace tactooth
