// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/base/kept_message.h"

#include <map>
#include <mutex>
#include <string>

namespace tactooth {

const Message& keptMessage(const Message& message) {
    static std::mutex mutex;
    static std::map<std::string, Message> messages;
    const std::lock_guard lock(mutex);
    return messages.try_emplace(message.in(Language::English), message).first->second;
}

}  // namespace tactooth
