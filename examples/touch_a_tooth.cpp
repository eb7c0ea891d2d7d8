// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Lowers a bur onto a tooth, a hundredth of a millimetre a millisecond, and prints what the hand feels.
// Usage: touch_a_tooth TOOTH.stl BUR.stl X Y Z (where the tip starts, mm)
#include <cstdio>
#include <cstdlib>

#include "tactooth/touch.h"

int main(int argc, char** argv) {
    if (argc != 6) return std::fprintf(stderr, "usage: %s TOOTH.stl BUR.stl X Y Z\n", argv[0]), 2;
    std::string error;
    const auto touch = tactooth::Touch::load(argv[1], argv[2], {.stiffness = 1.0, .damping = 0.002}, error);
    if (!touch) return std::fprintf(stderr, "%s\n", error.c_str()), 2;

    tactooth::RigidPose hand{{std::atof(argv[3]), std::atof(argv[4]), std::atof(argv[5])}};
    for (int tick = 0; tick < 2000; ++tick, hand.position[2] -= 0.01) {
        const tactooth::TouchResult felt = touch->follow(hand, 0.001);
        if (felt.touching)
            std::printf("z %.3f mm: depth %.4f mm, force %.3f N\n", hand.position[2], felt.depth, felt.force[2]);
        if (felt.depth > 0.3) break;
    }
}
