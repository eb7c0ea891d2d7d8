// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/haply/haply_survey.h"

#include "devices/haply/haply_link.h"

namespace tactooth {

Expected<std::vector<HaplyNames>> surveyHaply(const std::string& address) {
    constexpr double kPatience = 1;  // s: the service is on this machine
    auto link = HaplyLink::open(address, kPatience);
    if (!link) return Unexpected{link.error()};
    std::string first;
    if ((*link)->receive(first, kPatience) != HaplyLink::Heard::Message) {
        return unexpected("The Haply Inverse Service at " + address + " does not say who is there: restart it.");
    }
    return haplyDevices(first);
}

}  // namespace tactooth
