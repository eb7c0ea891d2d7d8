// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "collision/solid/solid.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// `mesh`, which came from `name`, as a solid. Fails with one sentence, in which `what` ("the surface of the tooth") is
/// its subject. `importNotes`, if given, gets what was done.
[[nodiscard]] Expected<TriangleMesh> solidFrom(TriangleMesh mesh, const std::string& name, const Message& what,
                                               const SolidOptions& options = {},
                                               std::vector<ImportNote>* importNotes = nullptr);

/// The same of a mesh file. Fails also if it cannot be read.
[[nodiscard]] Expected<TriangleMesh> loadSolid(const std::filesystem::path& file, const Message& what,
                                               const SolidOptions& options = {},
                                               std::vector<ImportNote>* importNotes = nullptr);

}  // namespace tactooth
