// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "haptics/haptic_simulation.h"
#include "instruments/builtin_tooth.h"
#include "session/kernel/session_event.h"

namespace tactooth::test {

/// A session of a seeded hand with a built-in tooth: it strokes the tooth and cuts it, and takes cuts back. The same
/// numbers give the same events in each run of one build.
struct ScriptedSession {
    /// A bur that works for some time.
    struct Part {
        std::string bur;  ///< of the catalogue
        Freedom freedom = Freedom::Translation;
        double end = 0;  ///< s since the session began
    };
    struct Change {
        double time = 0;  ///< s since the session began
        Edit edit = Edit::Undo;
    };

    std::string name;
    BuiltinToothKind tooth = BuiltinToothKind::LowerFirstMolar;
    int triangles = 1000;
    double voxel = 0.1;  ///< mm
    unsigned seed = 1;
    std::vector<Part> parts;      ///< the last one ends the session
    std::vector<Change> changes;  ///< ascending
    bool hasMirror = false;       ///< a mouth mirror behind the tooth, from half a second on until the last bur begins
    double depth = 3;             ///< mm: how far below the highest cusp the hand goes

    /// Records the session.
    void writeTo(const std::filesystem::path& file) const;

    friend void PrintTo(const ScriptedSession& session, std::ostream* out) { *out << session.name; }
};

}  // namespace tactooth::test
