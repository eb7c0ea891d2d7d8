// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/session_loader.h"

namespace tactooth {

std::optional<Error> SessionLoader::poll() {
    std::optional<Error> failure;
    const auto install = [&](auto loaded) {
        if (!loaded) return;
        if (*loaded) {
            model_.install(std::move(**loaded));
        } else {
            failure = loaded->error();
        }
    };
    install(tooth_.poll());
    install(bur_.poll());
    return failure;
}

}  // namespace tactooth
