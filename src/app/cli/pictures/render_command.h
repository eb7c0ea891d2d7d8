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
    std::string workOn;  ///< tooth of a case, shown alone; empty: the whole case
    std::filesystem::path materials;
    std::string view = "dentist";  ///< a name of kStandardViews, "dentist", or "AZIMUTH,ELEVATION" in degrees
    std::string size = "1600x1000";
    std::filesystem::path out;
    int turntable = 0;                     ///< number of pictures of a full rotation; 0: one picture
    std::string at;                        ///< "X,Y,Z" in the tooth's frame, mm; empty: the centre of the shown objects
    double span = 0;                       ///< height of the picture, mm; 0: the whole tooth
    std::string clip;                      ///< "SIDE" or "SIDE=MM"
    std::vector<std::string> transparent;  ///< "NAME=OPACITY"
    std::filesystem::path target;          ///< STL
    double range = 0.5;                    ///< of the colour scale, mm
    double tolerance = 0;                  ///< of the colour scale, mm
    bool ghost = false;                    ///< shows the cavity of `target` instead of the distance colours
    std::string stereo;                    ///< "side-by-side" or "anaglyph"
    std::string second;                    ///< a name of kStandardViews: adds a small picture from that side
    std::optional<double> mirror;          ///< diameter of the mirror's head, mm
    double fog = 0;
    double drops = 0;
    bool noBackground = false;
    bool marks = false;  ///< scale bar and letters of the directions
    bool mouth = false;  ///< the whole built-in mouth instead of one tooth
    MouthSpec mouthSpec;
    bool softTissues = false;  ///< of an open mouth
};

/// Writes a picture of a tooth, or the pictures of a full rotation around it.
[[nodiscard]] int runRender(const RenderOptions& options);

}  // namespace tactooth
