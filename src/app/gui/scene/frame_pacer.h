// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tactooth {

/// Rate and resolution of the picture while something moves. With a software renderer, pictures take at most half of
/// the time, so that the simulation keeps its share of the processor. Slow pictures first get a lower resolution. With
/// a graphics card moving pictures are as smooth as those at rest.
class FramePacer {
public:
    /// The change since the last picture.
    enum class Change {
        None,
        Spin,  ///< only the angle of the bur, which is blurred anyway
        Motion
    };

    /// Whether the next picture is due, `ms` after the last one began.
    [[nodiscard]] bool isDue(Change change, double ms) const;
    /// Resolution along each side, as a share of the full one.
    [[nodiscard]] double resolution(Change change) const;
    /// Whether pictures of motion also have smooth edges and soft shadows, as with a graphics card.
    [[nodiscard]] bool isSmooth() const { return smooth_ == Smooth::Yes; }
    /// A picture of `change` took `ms` to draw.
    void recordFrame(Change change, double ms);

private:
    enum class Smooth { NotYet, Yes, TooSlow };

    double cost_ = 0;  ///< of a picture of motion, ms, smoothed
    bool coarse_ = false;
    Smooth smooth_ = Smooth::NotYet;
    int drawn_ = 0;  ///< pictures of motion
};

/// Lowers the priority of the threads of the software renderer. Call it after the first OpenGL context is made. Without
/// a software renderer it does nothing.
void lowerSoftwareRendererPriority();

}  // namespace tactooth
