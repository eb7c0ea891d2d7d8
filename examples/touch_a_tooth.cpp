// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Lowers a bur onto a tooth by 0.01 mm each millisecond, and prints the contact force. Usage: touch_a_tooth TOOTH.stl
// BUR.stl X Y Z (start of the tip, mm)
#include <cstdio>
#include <cstdlib>

#include "tactooth/touch.h"

int main(int argc, char** argv) {
    if (argc != 6) return std::fprintf(stderr, "usage: %s TOOTH.stl BUR.stl X Y Z\n", argv[0]), 2;
    std::string error;
    const auto touch = tactooth::Touch::load(argv[1], argv[2], {.stiffness = 1.0, .damping = 0.002}, error);
    if (!touch) return std::fprintf(stderr, "%s\n", error.c_str()), 2;

    tactooth::RigidPose device{{std::atof(argv[3]), std::atof(argv[4]), std::atof(argv[5])}};
    for (int tick = 0; tick < 2000; ++tick, device.position[2] -= 0.01) {
        const tactooth::TouchResult contact = touch->follow(device, 0.001);
        if (contact.touching)
            std::printf("z %.3f mm: depth %.4f mm, force %.3f N\n", device.position[2], contact.depth,
                        contact.force[2]);
        if (contact.depth > 0.3) break;
    }
}
