// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <string>
#include <vector>

#include "hand/run_hand.h"

int main(int argc, char** argv) {
    const auto arguments = tactooth::HandArguments::from(std::vector<std::string>(argv, argv + argc));
    if (!arguments) {
        std::fputs("tactooth-hand is a part of Tactooth, which starts it for a device: run 'tactooth'.\n", stderr);
        return 2;
    }
    return tactooth::runHand(*arguments);
}
