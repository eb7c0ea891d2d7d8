// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this folder: what it says to people, in both languages.
namespace tactooth::msg {

inline constexpr MessageText kStreamForm{
    "stream_form", "--stream %1: this is no address of a stream; write it as udp://127.0.0.1:9870 or udp://[::1]:9870.",
    "--stream %1：ストリームの宛先として正しくありません。udp://127.0.0.1:9870 または udp://[::1]:9870 "
    "のように書いてください。"};
inline constexpr MessageText kStreamPort{"stream_port", "--stream %1: the port must be a whole number from 1 to 65535.",
                                         "--stream %1：ポートは 1 から 65535 までの整数でなければなりません。"};
inline constexpr MessageText kStreamHost{
    "stream_host", "--stream %1: the host is not found (%2); check its name, or give a number such as 127.0.0.1.",
    "--stream %1：ホストが見つかりません（%2）。名前を確かめるか、127.0.0.1 のような番号で指定してください。"};
inline constexpr MessageText kStreamSocket{"stream_socket", "--stream %1: nothing can be sent there: %2.",
                                           "--stream %1：そこへは送信できません：%2。"};

}  // namespace tactooth::msg
