// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/render_words.h"

#include <fmt/core.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include "app/common/inspection.h"
#include "geometry/number_text.h"

namespace tactooth {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator) {
            parts.emplace_back();
        } else {
            parts.back().push_back(c);
        }
    }
    return parts;
}

/// The numbers of "1,2,3"; nothing if one of them is none or their count is not `count`.
std::optional<std::vector<double>> numbers(const std::string& text, char separator, std::size_t count) {
    std::vector<double> result;
    for (const std::string& part : split(text, separator)) {
        const std::optional<double> number = toNumber<double>(part);
        if (!number) return std::nullopt;
        result.push_back(*number);
    }
    return result.size() == count ? std::optional(result) : std::nullopt;
}

}  // namespace

const StandardView* standardView(std::string_view name) {
    const auto found = std::find_if(kStandardViews.begin(), kStandardViews.end(),
                                    [&](const auto& view) { return view.first == name; });
    return found != kStandardViews.end() ? &found->second : nullptr;
}

Expected<PictureSize> parseSize(const std::string& text) {
    const auto sides = numbers(text, 'x', 2);
    const auto fits = [](double side) { return side >= 16 && side <= 16384 && side == static_cast<int>(side); };
    if (sides && fits((*sides)[0]) && fits((*sides)[1])) {
        return PictureSize{static_cast<int>((*sides)[0]), static_cast<int>((*sides)[1])};
    }
    return unexpected("the size '" + text + "' is none: write WIDTHxHEIGHT in pixels, each 16 to 16384, as 1920x1080.");
}

Expected<ViewWord> parseView(const std::string& text) {
    if (const StandardView* standard = standardView(text)) return ViewWord{*standard, {}};
    if (text == "dentist") return ViewWord{std::nullopt, {1.25, 0.62}};  // as the window opens
    if (const auto angles = numbers(text, ',', 2)) {
        return ViewWord{std::nullopt, {(*angles)[0] * kDegree, (*angles)[1] * kDegree}};
    }
    return unexpected("the view '" + text +
                      "' is none: choose occlusal, buccal, lingual, mesial, distal, dentist or AZIMUTH,ELEVATION in "
                      "degrees.");
}

Expected<Vec3> parsePoint(const std::string& text) {
    if (const auto values = numbers(text, ',', 3)) return Vec3((*values)[0], (*values)[1], (*values)[2]);
    return unexpected("the point '" + text + "' is none: write X,Y,Z in mm, as 1.5,-2,7.");
}

Expected<ClipWord> parseClip(const std::string& text) {
    const auto parts = split(text, '=');
    const StandardView* side = standardView(parts.front());
    const std::optional<double> way = parts.size() == 2 ? toNumber<double>(parts[1]) : std::optional<double>(0);
    if (side != nullptr && way && parts.size() <= 2) return ClipWord{*side, *way};
    return unexpected("the clip plane '" + text +
                      "' is none: choose occlusal, buccal, lingual, mesial or distal, and if need be how far from the "
                      "tooth's middle, as buccal=1.5 (mm).");
}

Expected<OpacityWord> parseOpacity(const std::string& text) {
    const auto parts = split(text, '=');
    const double opacity = parts.size() == 2 ? toNumber<double>(parts[1]).value_or(-1) : -1;
    const std::optional<MaterialId> material = materialFromName(parts.front());
    if (material && opacity >= 0 && opacity <= 1) return OpacityWord{*material, static_cast<float>(opacity)};
    return unexpected("'" + text +
                      "' makes nothing transparent: write a material and its opacity from 0 to 1, as enamel=0.3.");
}

std::filesystem::path numberedFile(const std::filesystem::path& file, int number) {
    return file.parent_path() / fmt::format("{}-{:03}{}", file.stem().string(), number, file.extension().string());
}

}  // namespace tactooth
