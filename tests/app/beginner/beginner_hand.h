// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>
#include <random>
#include <vector>

#include "session/hands/pointer_view.h"

namespace tactooth::test {

/// What somebody at the mouse sees of the picture. Pixels.
struct SeenPicture {
    std::vector<Vec2> outline;    ///< of the cavity to be cut, in order
    std::vector<Vec2> ring;       ///< where the bur lands; empty: it cannot be seen
    Vec2 landing = Vec2::Zero();  ///< end of the plumb line
    std::optional<double> depth;  ///< the number at the tip, mm
};

/// A place to which the hand goes, in the picture.
struct HandPlace {
    Vec2 at = Vec2::Zero();
    /// Beside the outline: the place of the outline that the ring is to touch there, and the direction to it, unit.
    struct Rim {
        Vec2 place, outward;
    };
    std::optional<Rim> rim;
};

/// A careful beginner at the mouse: goes slowly to and fro within the outline that the picture shows, then along it, so
/// that the ring touches it, waits for the depth that was set, and lets go at the end. Sees everything with
/// a delay, the reaction time, and has a tremor of a pixel.
class BeginnerHand {
public:
    struct Habits {
        double reaction = 0.25;   ///< s
        double tremor = 1;        ///< pixels, standard deviation
        double speed = 2.0;       ///< mm/s; half of it along the outline
        double tolerance = 0.06;  ///< mm of the depth, within which the hand goes on
        double longest = 165;     ///< s, after which no other pass is begun
        double patience = 1.5;    ///< s without progress
    };
    enum class Button { Up, Down };
    struct Action {
        Vec2 pixel = Vec2::Zero();
        Button button = Button::Up;
        bool isDone = false;
    };

    /// `goalDepth`: that was set, mm; `pixelPitch`: mm for each pixel.
    BeginnerHand(unsigned seed, const Habits& habits, double goalDepth, double pixelPitch);
    BeginnerHand(unsigned seed, double goalDepth, double pixelPitch)
        : BeginnerHand(seed, Habits(), goalDepth, pixelPitch) {}

    /// The next event of the mouse, `dt` s after the last one.
    [[nodiscard]] Action next(double dt, const SeenPicture& picture);

private:
    struct Moment {
        double time;  // s
        SeenPicture picture;
        Vec2 at;  // where the hand was
    };
    void plan(const SeenPicture& seen);
    void steerToRim(double dt, const SeenPicture& seen, double behind);
    void goOn(double dt);
    [[nodiscard]] Vec2 tremble(const Vec2& place);

    Habits habits_;
    double goalDepth_, pixelPitch_;
    std::mt19937 random_;
    std::deque<Moment> seen_;
    double time_ = 0, waited_ = 0;
    std::vector<HandPlace> path_;
    std::size_t place_ = 0;
    Vec2 on_ = Vec2::Zero();  // the place on the path, between two of its places
    double push_ = 0;         // pixels farther out than the path, as the ring has shown
    int pass_ = 1;
    double waitedInPass_ = 0;  // s: something was still to be cut
    double leastToDo_ = 1e9;   // pixels, since the hand has moved on
    Vec2 at_ = Vec2::Zero();
    Button button_ = Button::Up;
};

/// The middles of circles with this radius (pixels) that lie within `outline`, in rows to and fro along its longer
/// side. Empty where none fits.
[[nodiscard]] std::vector<HandPlace> rowsWithin(const std::vector<Vec2>& outline, double radius);

/// The middles of such circles that touch the outline, once round. Empty where none fits.
[[nodiscard]] std::vector<HandPlace> wayRound(const std::vector<Vec2>& outline, double radius);

}  // namespace tactooth::test
