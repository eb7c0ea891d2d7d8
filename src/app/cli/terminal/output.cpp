// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/terminal/output.h"

#include <cerrno>

namespace tactooth {
namespace {

int firstError = 0;

void keepError(bool isWritten) {
    if (!isWritten && firstError == 0) firstError = errno == 0 ? EIO : errno;
}

}  // namespace

void writeTo(std::FILE* stream, std::string_view text) {
    errno = 0;
    const bool isWritten = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
    if (stream == stdout) keepError(isWritten);
}

int outputError() {
    errno = 0;
    const bool isWritten = std::fflush(stdout) == 0;
    keepError(isWritten);
    if (firstError == 0 && std::ferror(stdout) != 0) firstError = -1;
    return firstError;
}

}  // namespace tactooth
