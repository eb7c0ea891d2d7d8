// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tactooth {

// Pieces of the drawings (SVG) of a report. All lengths in mm on paper, from the upper left corner.

/// The beginning of a drawing of this size. Without the address of its name space, so that a page with it names none.
[[nodiscard]] std::string svgHead(double width, double height);
/// `style`: attributes of the stroke.
[[nodiscard]] std::string svgLine(double x1, double y1, double x2, double y2, std::string_view style);
/// `anchor`: the part of the text at x: "start", "middle" or "end".
[[nodiscard]] std::string svgText(double x, double y, std::string_view anchor, std::string_view words,
                                  std::string_view colour = "#55636f");

}  // namespace tactooth
