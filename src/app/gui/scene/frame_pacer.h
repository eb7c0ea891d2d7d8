// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tactooth {

/// How often and how finely the picture is drawn while things move, so that the cutting and the hand keep their share
/// of a computer that draws by software: never more than half of the time goes into pictures, and where they are slow
/// they get coarser first. Where a graphics card makes them in no time they are as smooth as those at rest.
class FramePacer {
public:
    /// What has changed since the last picture.
    enum class Change {
        None,
        Spin,  ///< nothing but the turn of the bur, which is a blur anyway
        Motion
    };

    /// Whether it is time for a picture, `ms` after the last one began.
    [[nodiscard]] bool isDue(Change change, double ms) const;
    /// Share of the picture's pixels along each side.
    [[nodiscard]] double resolution(Change change) const;
    /// Whether pictures of motion may have smooth edges and soft shadows as well, as where a graphics card draws.
    [[nodiscard]] bool isSmooth() const { return smooth_ == Smooth::Yes; }
    /// The picture of `change` took `ms` to draw.
    void recordFrame(Change change, double ms);

private:
    enum class Smooth { NotYet, Yes, TooSlow };

    double cost_ = 0;  ///< of a picture while things move, ms, smoothed
    bool coarse_ = false;
    Smooth smooth_ = Smooth::NotYet;
    int drawn_ = 0;  ///< pictures of motion
};

/// Lets the threads of the software renderer give way to all others of this computer. Call after the first OpenGL
/// context was made; without a software renderer it does nothing.
void lowerSoftwareRendererPriority();

}  // namespace tactooth
