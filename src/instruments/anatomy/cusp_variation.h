// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Cusps that vary most between people: the fifth cusp of lower molars, the distolingual cusp of upper ones, and the
// tubercle of Carabelli.
#pragma once

#include <random>

#include "instruments/anatomy/posterior_tooth.h"

namespace tactooth {

/// Changes them in the plan of an average tooth of the right side; other teeth stay as they are.
void varyCuspNumber(PosteriorToothPlan& plan, std::mt19937& random);

}  // namespace tactooth
