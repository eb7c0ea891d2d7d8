// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/expected.h"
#include "session/kernel/session_event.h"

// What a recording says of a BeginEvent: a text in JSON, and the surface of the bur as an attachment, once for each
// bur.

namespace tactooth {

/// A surface as an attachment. Its name is made of the hash of its content, so equal surfaces have equal names.
struct MeshAttachment {
    std::string name;
    std::vector<std::byte> content;
};
[[nodiscard]] MeshAttachment attachmentOf(const TriangleMesh& mesh);
/// Bit for bit the surface that it was made of; nothing for bytes of another form. It takes memory in proportion to the
/// bytes.
[[nodiscard]] std::optional<TriangleMesh> meshOf(std::span<const std::byte> content);

/// The event as JSON. `bur`: the name of the attachment of `event.instrument.shape`.
[[nodiscard]] std::string setupText(const BeginEvent& event, const std::string& bur);

/// Finds the surface of a name; nothing if there is none.
using MeshFinder = std::function<std::optional<TriangleMesh>(const std::string& name)>;
/// Reads what setupText wrote. `materials`: of the tooth. Fails with one sentence that names what is wrong; `file`
/// stands for the recording in it.
[[nodiscard]] Expected<BeginEvent> parseSetup(const std::string& text, const MaterialRegistry& materials,
                                              const MeshFinder& findMesh, const std::string& file);

}  // namespace tactooth
