// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/terminal/too_large_message.h"

#include <fmt/core.h>

#include <exception>
#include <filesystem>
#include <optional>

#include "app/cli/terminal/messages.h"
#include "geometry/files/file_bytes.h"
#include "geometry/io/mesh_file.h"

namespace tactooth {
namespace {

constexpr double kLargestMouth = 300;  // mm

/// The box of a surface; nothing if the argument is not a readable surface.
std::optional<Box3> boxOf(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) return std::nullopt;
    try {
        const auto mesh = loadMesh(file);
        if (mesh) return boundingBox(*mesh);
    } catch (const std::exception&) {  // this file may be the one that does not fit
    }
    return std::nullopt;
}

}  // namespace

Error tooLargeMessage(std::span<const char* const> arguments) {
    Error sentence(msg::kMemoryTooSmall);
    double largest = kLargestMouth;
    for (const std::string argument : arguments) {
        const std::filesystem::path file = argument.substr(argument.find('=') + 1);  // "enamel=FILE"
        const std::optional<Box3> box = boxOf(file);
        if (!box || !(box->sizes().maxCoeff() > largest)) continue;
        largest = box->sizes().maxCoeff();
        const Vec3 size = box->sizes();
        const auto whole = [](double length) { return fmt::format("{:.0f}", length); };
        sentence = {msg::kSurfaceTooLarge, displayName(file), whole(size.x()), whole(size.y()), whole(size.z())};
    }
    return sentence;
}

}  // namespace tactooth
