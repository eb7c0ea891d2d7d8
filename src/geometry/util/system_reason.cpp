// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/system_reason.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include "geometry/util/messages.h"

namespace tactooth {
namespace {

constexpr std::array<std::pair<int, const MessageText*>, 18> kReasons = {{
    {EPERM, &msg::kNotPermitted},
    {ENOENT, &msg::kNoSuchFile},
    {EIO, &msg::kInputOutputError},
    {ENOMEM, &msg::kNoMemory},
    {EACCES, &msg::kPermissionDenied},
    {EBUSY, &msg::kBusy},
    {EEXIST, &msg::kFileExists},
    {ENOTDIR, &msg::kNotFolder},
    {EISDIR, &msg::kIsFolder},
    {EMFILE, &msg::kTooManyOpenFiles},
    {EFBIG, &msg::kFileTooLarge},
    {ENOSPC, &msg::kNoSpace},
    {EROFS, &msg::kReadOnly},
    {EPIPE, &msg::kBrokenPipe},
    {ENAMETOOLONG, &msg::kNameTooLong},
    {ENOTEMPTY, &msg::kFolderNotEmpty},
    {ELOOP, &msg::kTooManyLinks},
    {EDQUOT, &msg::kQuotaExceeded},
}};

}  // namespace

Message systemReason(int reason) {
    const auto* const found = std::ranges::find(kReasons, reason, &std::pair<int, const MessageText*>::first);
    if (found != kReasons.end()) return *found->second;
    return Message::verbatim(std::generic_category().message(reason));
}

Message systemReason(const std::error_code& reason) {
    const bool isErrno = reason.category() == std::generic_category() || reason.category() == std::system_category();
#ifdef _WIN32
    return isErrno && reason.category() == std::generic_category() ? systemReason(reason.value())
                                                                   : Message::verbatim(reason.message());
#else
    return isErrno ? systemReason(reason.value()) : Message::verbatim(reason.message());
#endif
}

}  // namespace tactooth
