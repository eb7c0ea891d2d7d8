// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/shapes/mouth_command.h"

namespace tactooth {

struct RenderOptions {
    std::filesystem::path tooth;  ///< STL, case or saved tooth; empty: the built-in molar
    std::vector<std::string> layers;
    std::string workOn;  ///< tooth of a case, shown alone; empty: all of it
    std::filesystem::path materials;
    std::string view = "dentist";  ///< a name of kStandardViews, "dentist", or "AZIMUTH,ELEVATION" in degrees
    std::string size = "1600x1000";
    std::filesystem::path out;
    int turntable = 0;                     ///< pictures of a whole turn; 0: one picture
    std::string at;                        ///< "X,Y,Z" in the tooth's frame, mm; empty: the middle of what is shown
    double span = 0;                       ///< mm that the picture is high; 0: the whole tooth
    std::string clip;                      ///< "SIDE" or "SIDE=MM"
    std::vector<std::string> transparent;  ///< "NAME=OPACITY"
    std::filesystem::path target;          ///< STL
    double range = 0.5;                    ///< mm, of the colours
    bool ghost = false;                    ///< shows the cavity of `target` instead of the colours
    std::string stereo;                    ///< "side-by-side" or "anaglyph"
    std::string second;                    ///< a name of kStandardViews: a small picture from there in the corner
    std::optional<double> mirror;          ///< diameter of its head, mm
    double fog = 0;
    double drops = 0;
    bool noBackground = false;
    bool mouth = false;  ///< the whole built-in mouth instead of a tooth
    MouthSpec mouthSpec;
};

/// Writes a picture of a tooth, or the pictures of a turn around it.
[[nodiscard]] int runRender(const RenderOptions& options);

}  // namespace tactooth
