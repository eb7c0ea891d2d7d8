// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/haply/haply_enumeration.h"

#include "devices/base/messages.h"
#include "devices/haply/haply_connection.h"

namespace tactooth {

Expected<std::vector<HaplyNames>> enumerateHaply(const std::string& address) {
    constexpr double kConnectTimeout = 1;  // s: the service is on this machine
    auto link = HaplyConnection::open(address, kConnectTimeout);
    if (!link) return Unexpected{link.error()};
    std::string first;
    if ((*link)->receive(first, kConnectTimeout) != HaplyConnection::ReceiveStatus::Message) {
        return unexpected(msg::kHaplySaysNothing, address);
    }
    return haplyDevices(first);
}

}  // namespace tactooth
