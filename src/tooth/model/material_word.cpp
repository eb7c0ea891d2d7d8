// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/model/material_word.h"

#include "tooth/model/messages.h"

namespace tactooth {

Message materialWord(std::string_view name) {
    for (const MessageText* const each :
         {&msg::kEnamel, &msg::kDentin, &msg::kPulp, &msg::kCaries, &msg::kRestoration, &msg::kOther}) {
        if (each->id == name) return *each;
    }
    return Message::verbatim(std::string(name));
}

}  // namespace tactooth
