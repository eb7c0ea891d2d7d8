// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "app/cli/info_text.h"

namespace tactooth {
namespace {

/// 325312 as "325,312".
std::string grouped(std::size_t count) {
    std::string digits = std::to_string(count);
    for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), 1, ',');
    return digits;
}

std::string orientationOf(const MeshReport& report) {
    if (!report.oriented()) return "mixed: neighbouring triangles disagree";
    if (report.insideOut()) return "inside out";
    return report.closed() ? "outward" : "consistent";
}

std::string closednessOf(const MeshReport& report) {
    if (report.closed()) return "yes";
    return report.boundaryEdges > 0 ? fmt::format("no, {} open edges", grouped(report.boundaryEdges)) : "no";
}

std::string row(std::string_view label, std::string_view value) { return fmt::format("  {:<13} {}\n", label, value); }

std::string findingRows(const MeshReport& report) {
    const std::vector<std::string> sentences = findings(report);
    if (sentences.empty()) return row("Findings", "none");
    std::string rows;
    for (const std::string& sentence : sentences) rows += row(rows.empty() ? "Findings" : "", sentence);
    return rows;
}

}  // namespace

std::string infoTable(std::string_view name, const MeshReport& report, const std::vector<Remark>& remarks) {
    const Vec3 size = report.box.sizes();
    std::string table = fmt::format("{}\n", name);
    table += row("Triangles", grouped(report.triangles));
    table += row("Vertices", grouped(report.vertices));
    table += row("Size", fmt::format("{:.2f} x {:.2f} x {:.2f} mm", size.x(), size.y(), size.z()));
    table += row("Closed", closednessOf(report));
    table += row("Orientation", orientationOf(report));
    table += row("Shells", grouped(report.shells.size()));
    if (report.genus()) table += row("Tunnels", std::to_string(*report.genus()));
    table += row("Volume",
                 report.volume() ? fmt::format("{:.2f} mm3", *report.volume()) : "none: the surface has no inside");
    table += row("Surface area", fmt::format("{:.2f} mm2", report.area));
    table += findingRows(report);
    for (std::size_t i = 0; i < remarks.size(); ++i) table += row(i == 0 ? "Reading" : "", inWords(remarks[i]));
    return table;
}

}  // namespace tactooth
