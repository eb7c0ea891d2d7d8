// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/render/image.h"
#include "view/render/renderer.h"

namespace tactooth {

/// An OpenGL context without window, screen or desktop, for pictures in files. Use it on the thread that made it; that
/// thread must not hold another OpenGL context meanwhile.
class OffscreenRenderer {
public:
    [[nodiscard]] static Expected<OffscreenRenderer> create();
    OffscreenRenderer(OffscreenRenderer&&) noexcept;
    OffscreenRenderer& operator=(OffscreenRenderer&&) noexcept;
    ~OffscreenRenderer();

    [[nodiscard]] Expected<Image> render(const Scene& scene, ImageSize size, const RenderSettings& settings = kFine);

    /// Which object each pixel of the picture shows: see object_ids.h.
    [[nodiscard]] Expected<Image> identify(const Scene& scene, ImageSize size, const MarkedBall& ball = {});

    /// The driver's name for the renderer ("llvmpipe (LLVM 15.0.6, 256 bits)").
    [[nodiscard]] std::string device() const;
    [[nodiscard]] std::size_t lastUpload() const;

private:
    struct Parts;
    explicit OffscreenRenderer(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace tactooth
