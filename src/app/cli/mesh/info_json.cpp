// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "app/cli/terminal/info_text.h"
#include "geometry/util/degree.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }

Json toJson(const Box3& box) {
    return {{"min", toJson(Vec3(box.min()))}, {"max", toJson(Vec3(box.max()))}, {"size", toJson(Vec3(box.sizes()))}};
}

Json toJson(const ShellReport& shell) {
    return {{"triangles", shell.triangles}, {"signed_volume", shell.signedVolume}, {"box", toJson(shell.box)}};
}

template <class Number>
Json orNull(const std::optional<Number>& number) {
    return number ? Json(*number) : Json(nullptr);
}

}  // namespace

std::string infoJson(std::string_view name, const SurfaceFacts& facts) {
    const MeshReport& report = facts.used;
    const bool isSolid = facts.solid.isSolid();
    Json json = {{"file", name},
                 {"triangles", facts.storedTriangles},
                 {"vertices", report.vertices},
                 {"box", toJson(report.box)},
                 {"crown_tilt_degrees", facts.crownTilt ? Json(*facts.crownTilt / kDegree) : Json(nullptr)},
                 {"closed", report.closed()},
                 {"oriented", report.oriented()},
                 {"watertight", isSolid},
                 {"inside_out", facts.storedInsideOut},
                 {"volume", orNull(isSolid ? report.volume() : std::nullopt)},
                 {"area", report.area},
                 {"genus", orNull(report.genus())},
                 {"euler_characteristic", report.eulerCharacteristic},
                 {"boundary_edges", report.boundaryEdges},
                 {"non_manifold_edges", report.nonManifoldEdges},
                 {"crossing_triangles", facts.solid.selfIntersectingTriangles},
                 {"overlap", facts.solid.overlap},
                 {"inconsistent_edges", report.inconsistentEdges},
                 {"pinched_vertices", report.pinchedVertices},
                 {"degenerate_triangles", report.degenerateTriangles},
                 {"flat_triangles", report.flatTriangles},
                 {"duplicate_triangles", report.duplicateTriangles},
                 {"shells", Json::array()},
                 {"findings", facts.findings()}};
    for (const ShellReport& shell : report.shells) json["shells"].push_back(toJson(shell));
    json["remarks"] = Json::array();
    for (const ImportNote& importNote : facts.reading) json["remarks"].push_back(inWords(importNote));
    // A file name may contain bytes that are not UTF-8. JSON does not allow them.
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tactooth
