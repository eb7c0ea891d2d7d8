// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/pictures/render_arguments.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/cli/terminal/messages.h"
#include "app/common/inspection.h"
#include "geometry/util/degree.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

constexpr double kMaxPixels = 4096.0 * 4096;  // of a picture: about 50 bytes each while it is drawn
constexpr double kMaxTurn = 3600;             // degrees
constexpr double kFarthest = 1000;            // mm from the tooth

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

/// Parses numbers such as "1,2,3". Returns nothing if an entry is not a number or beyond +-`most`, or if there are not
/// exactly `count` entries.
std::optional<std::vector<double>> numbers(const std::string& text, char separator, std::size_t count, double most) {
    std::vector<double> result;
    for (const std::string& part : split(text, separator)) {
        const std::optional<double> number = toNumber<double>(part);
        if (!number || !(std::abs(*number) <= most) || result.size() == count) return std::nullopt;
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

Expected<ImageSize> parseSize(const std::string& text) {
    constexpr double kMinSide = 16, kMaxSide = 16384;
    const auto sides = numbers(text, 'x', 2, kMaxSide);
    const auto fits = [](double side) { return side >= kMinSide && side == std::trunc(side); };
    if (!sides || !fits(sides->front()) || !fits(sides->back())) {
        return unexpected(msg::kPictureSizeUnknown, quotedWord(text));
    }
    if (sides->front() * sides->back() > kMaxPixels) {
        return unexpected(msg::kPictureTooLarge, quotedWord(text));
    }
    return ImageSize{static_cast<int>(sides->front()), static_cast<int>(sides->back())};
}

Expected<ViewArgument> parseView(const std::string& text) {
    if (const StandardView* standard = standardView(text)) return ViewArgument{*standard, {}};
    if (text == "dentist") return ViewArgument{std::nullopt, {1.25, 0.62}};  // the first view of the window
    if (const auto angles = numbers(text, ',', 2, kMaxTurn)) {
        return ViewArgument{std::nullopt, {(*angles)[0] * kDegree, (*angles)[1] * kDegree}};
    }
    return unexpected(msg::kViewUnknown, quotedWord(text));
}

Expected<Vec3> parsePoint(const std::string& text) {
    if (const auto at = numbers(text, ',', 3, kFarthest)) return Vec3((*at)[0], (*at)[1], (*at)[2]);
    return unexpected(msg::kPointUnknown, quotedWord(text));
}

Expected<ClipArgument> parseClip(const std::string& text) {
    const auto parts = split(text, '=');
    const StandardView* side = standardView(parts.front());
    const std::optional<double> offset = parts.size() == 2 ? toNumber<double>(parts[1]) : std::optional<double>(0);
    const bool isNear = offset && std::abs(*offset) <= kFarthest;
    if (side != nullptr && isNear && parts.size() <= 2) return ClipArgument{*side, *offset};
    return unexpected(msg::kClipPlaneUnknown, quotedWord(text));
}

Expected<OpacityArgument> parseOpacity(const std::string& text, const MaterialRegistry& materials) {
    const auto parts = split(text, '=');
    const double opacity = parts.size() == 2 ? toNumber<double>(parts[1]).value_or(-1) : -1;
    const std::optional<MaterialId> material = materials.find(parts.front());
    if (material && opacity >= 0 && opacity <= 1) return OpacityArgument{*material, static_cast<float>(opacity)};
    return unexpected(msg::kNothingTransparent, quotedWord(text));
}

std::filesystem::path numberedFile(const std::filesystem::path& file, int number) {
    return file.parent_path() / fmt::format("{}-{:03}{}", file.stem().native(), number, file.extension().native());
}

}  // namespace tactooth
