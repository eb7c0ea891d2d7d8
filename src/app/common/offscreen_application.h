// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "geometry/util/expected.h"

class QApplication;
class QImage;

namespace tactooth {

/// Lets Qt draw pictures in a program without a window. Creates an application without a display for its lifetime, if
/// there is none yet.
class OffscreenApplication {
public:
    OffscreenApplication();
    ~OffscreenApplication();
    OffscreenApplication(const OffscreenApplication&) = delete;
    OffscreenApplication& operator=(const OffscreenApplication&) = delete;

private:
    std::unique_ptr<QApplication> application_;
};

/// Writes `image` as PNG; the file appears when it is complete.
[[nodiscard]] Expected<void> savePng(const QImage& image, const std::filesystem::path& path);
/// The same as JPEG, for small pictures that the program brings along.
[[nodiscard]] Expected<void> saveJpeg(const QImage& image, const std::filesystem::path& path);

}  // namespace tactooth
