// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/terminal/info_text.h"
#include "app/cli/terminal/messages.h"
#include "patient/tooth_frame.h"

namespace tactooth {

SurfaceFacts surfaceFacts(const TriangleMesh& mesh) {
    const MeshReport stored = reportOn(mesh);
    ExaminedSolid examined = examineSolid(mesh);
    const bool isChanged = examined.mesh.triangles != mesh.triangles || examined.mesh.vertices != mesh.vertices;
    const bool isSolid = examined.report.isSolid();
    return {stored.triangles,  stored.insideOut(),
            stored.oriented(), isChanged ? reportOn(examined.mesh) : stored,
            examined.report,   isSolid ? crownTilt(examined.mesh) : std::nullopt};
}

std::vector<std::string> SurfaceFacts::findings() const {
    std::vector<std::string> sentences = tactooth::findings(used);
    for (const ImportNote& importNote : notesOn(solid, msg::kWhenUsed)) sentences.push_back(inWords(importNote));
    if (solid.flaw == SolidFlaw::Overlapping || solid.flaw == SolidFlaw::SelfIntersecting ||
        solid.flaw == SolidFlaw::Empty || (solid.flaw == SolidFlaw::NonOrientable && used.oriented())) {
        sentences.push_back(flawSentence(solid, msg::kTheSurfaceItself).in(Language::English) + ".");
    }
    return sentences;
}

}  // namespace tactooth
