// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "app/cli/terminal/info_text.h"
#include "geometry/util/degree.h"

namespace tactooth {
namespace {

/// Formats 325312 as "325,312".
std::string grouped(std::size_t count) {
    std::string digits = std::to_string(count);
    for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), 1, ',');
    return digits;
}

std::string orientationOf(const SurfaceFacts& facts) {
    if (!facts.storedOriented) return "mixed: neighbouring triangles disagree";
    if (facts.storedInsideOut) return "inside out";
    return facts.used.closed() ? "outward" : "consistent";
}

std::string volumeOf(const SurfaceFacts& facts) {
    if (facts.solid.isSolid() && facts.used.volume()) return fmt::format("{:.2f} mm3", *facts.used.volume());
    return facts.solid.flaw == SolidFlaw::Overlapping || facts.solid.flaw == SolidFlaw::SelfIntersecting
               ? "none: parts of the surface reach into each other"
               : "none: the surface has no inside";
}

std::string closednessOf(const MeshReport& report) {
    if (report.closed()) return "yes";
    return report.boundaryEdges > 0 ? fmt::format("no, {} open edges", grouped(report.boundaryEdges)) : "no";
}

std::string row(std::string_view label, std::string_view value) { return fmt::format("  {:<13} {}\n", label, value); }

std::string findingRows(const SurfaceFacts& facts) {
    const std::vector<std::string> sentences = facts.findings();
    if (sentences.empty()) return row("Findings", "none");
    std::string rows;
    for (const std::string& sentence : sentences) rows += row(rows.empty() ? "Findings" : "", sentence);
    return rows;
}

}  // namespace

std::string infoTable(std::string_view name, const SurfaceFacts& facts) {
    const MeshReport& report = facts.used;
    const Vec3 size = report.box.isEmpty() ? Vec3::Zero() : Vec3(report.box.sizes());
    std::string table = fmt::format("{}\n", name);
    table += row("Triangles", grouped(facts.storedTriangles));
    table += row("Vertices", grouped(report.vertices));
    table += row("Size", fmt::format("{:.2f} x {:.2f} x {:.2f} mm", size.x(), size.y(), size.z()));
    if (facts.crownTilt) {
        table += row("Long axis", fmt::format("thicker end {:.0f} degrees from +z", *facts.crownTilt / kDegree));
    }
    table += row("Closed", closednessOf(report));
    table += row("Orientation", orientationOf(facts));
    table += row("Shells", grouped(report.shells.size()));
    if (report.genus()) table += row("Tunnels", std::to_string(*report.genus()));
    table += row("Volume", volumeOf(facts));
    table += row("Surface area", fmt::format("{:.2f} mm2", report.area));
    table += findingRows(facts);
    for (std::size_t i = 0; i < facts.reading.size(); ++i) {
        table += row(i == 0 ? "Reading" : "", inWords(facts.reading[i]));
    }
    return table;
}

}  // namespace tactooth
