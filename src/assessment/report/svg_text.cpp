// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/report/svg_text.h"

#include <fmt/core.h>

#include "assessment/report/page_head.h"

namespace tactooth {

std::string svgHead(double width, double height) {
    return fmt::format(
        "<svg width=\"{0:.1f}mm\" height=\"{1:.1f}mm\" viewBox=\"0 0 {0:.1f} {1:.1f}\" font-family=\"{2}\" "
        "font-weight=\"normal\">\n",
        width, height, kPageFonts);
}

std::string svgLine(double x1, double y1, double x2, double y2, std::string_view style) {
    return fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" {}/>\n", x1, y1, x2, y2, style);
}

std::string svgText(double x, double y, std::string_view anchor, std::string_view words, std::string_view colour) {
    return fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\" fill=\"{}\" font-size=\"2.5\">{}</text>\n",
                       x, y, anchor, colour, words);
}

}  // namespace tactooth
