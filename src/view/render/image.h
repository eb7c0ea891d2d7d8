// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "geometry/util/expected.h"
#include "view/camera/camera.h"
#include "view/gl/rgba.h"

namespace tactooth {

/// A picture, rows from top to bottom.
struct Image {
    ImageSize size;
    std::vector<Rgba> pixels;

    [[nodiscard]] const Rgba& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x)];
    }
    bool operator==(const Image&) const = default;
};

/// Writes `image` as PNG. The file appears complete or not at all.
[[nodiscard]] Expected<void> writePng(const Image& image, const std::filesystem::path& file);

/// Reads a PNG of any colour type.
[[nodiscard]] Expected<Image> readPng(const std::filesystem::path& file);

/// How two pictures of the same size differ.
struct ImageDifference {
    double mean = 0;        ///< mean absolute difference of red, green and blue, 0..255
    double worstShare = 0;  ///< share of the pixels with a channel that differs by more than 16
};
[[nodiscard]] ImageDifference compare(const Image& a, const Image& b);

}  // namespace tactooth
