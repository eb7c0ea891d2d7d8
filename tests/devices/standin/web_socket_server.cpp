// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "web_socket_server.h"

#include <sys/socket.h>

#include <array>
#include <bit>
#include <cstdint>

namespace tactooth::test {
namespace {

/// SHA-1 (RFC 3174).
std::array<unsigned char, 20> digestOf(std::string text) {
    std::array<std::uint32_t, 5> h = {0x67452301, 0xEFCDAB89, 0x98BADCFE, 0x10325476, 0xC3D2E1F0};
    const std::uint64_t bits = 8 * text.size();
    text.push_back(static_cast<char>(0x80));
    while (text.size() % 64 != 56) text.push_back(0);
    for (int shift = 56; shift >= 0; shift -= 8) text.push_back(static_cast<char>(bits >> shift));
    for (std::size_t block = 0; block < text.size(); block += 64) {
        std::array<std::uint32_t, 80> w{};
        for (std::size_t i = 0; i < 64; ++i) w[i / 4] = w[i / 4] << 8 | static_cast<unsigned char>(text[block + i]);
        for (std::size_t i = 16; i < 80; ++i) w[i] = std::rotl(w[i - 3] ^ w[i - 8] ^ w[i - 14] ^ w[i - 16], 1);
        auto [a, b, c, d, e] = h;
        for (std::size_t i = 0; i < 80; ++i) {
            const std::uint32_t mixed = i < 20   ? (b & c) | (~b & d)
                                        : i < 40 ? b ^ c ^ d
                                        : i < 60 ? (b & c) | (b & d) | (c & d)
                                                 : b ^ c ^ d;
            constexpr std::array<std::uint32_t, 4> kRound = {0x5A827999, 0x6ED9EBA1, 0x8F1BBCDC, 0xCA62C1D6};
            const std::uint32_t next = std::rotl(a, 5) + mixed + e + w[i] + kRound[i / 20];
            e = d;
            d = c;
            c = std::rotl(b, 30);
            b = a;
            a = next;
        }
        const std::array<std::uint32_t, 5> sum = {a, b, c, d, e};
        for (std::size_t i = 0; i < 5; ++i) h[i] += sum[i];
    }
    std::array<unsigned char, 20> digest{};
    for (std::size_t i = 0; i < 20; ++i) digest[i] = static_cast<unsigned char>(h[i / 4] >> (24 - 8 * (i % 4)));
    return digest;
}

/// Base64 of 20 bytes.
std::string letters(const std::array<unsigned char, 20>& bytes) {
    constexpr const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::uint32_t third = i + 2 < bytes.size() ? bytes[i + 2] : 0U;
        const std::uint32_t group =
            static_cast<std::uint32_t>(bytes[i]) << 16 | static_cast<std::uint32_t>(bytes[i + 1]) << 8 | third;
        for (int shift = 18; shift >= 0; shift -= 6) text.push_back(kLetters[group >> shift & 63]);
    }
    text.back() = '=';  // 20 bytes are one fewer than a multiple of three
    return text;
}

}  // namespace

std::string webSocketAnswer(const std::string& key) {
    return letters(digestOf(key + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11"));
}

bool WebSocketServer::readBytes(unsigned char* bytes, std::size_t count) {
    return recv(socket_, bytes, count, MSG_WAITALL) == static_cast<ssize_t>(count);
}

bool WebSocketServer::writeAll(const std::string& bytes) {
    return ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size());
}

bool WebSocketServer::readRequest(std::string& request) {
    unsigned char byte = 0;
    while (request.find("\r\n\r\n") == std::string::npos) {
        if (!readBytes(&byte, 1)) return false;
        request.push_back(static_cast<char>(byte));
    }
    return true;
}

bool WebSocketServer::refuseHandshake() {
    std::string request;
    if (readRequest(request)) (void)writeAll("HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n");
    return false;
}

bool WebSocketServer::handshakeWith() {
    std::string request;
    if (!readRequest(request)) return false;
    constexpr std::string_view kField = "Sec-WebSocket-Key: ";
    const std::size_t start = request.find(kField);
    if (start == std::string::npos) return false;
    const std::size_t key = start + kField.size();
    return writeAll(
        "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        "Sec-WebSocket-Accept: " +
        webSocketAnswer(request.substr(key, request.find("\r\n", key) - key)) + "\r\n\r\n");
}

bool WebSocketServer::send(const std::string& text) {
    std::string frame = "\x81";
    if (text.size() < 126) {
        frame.push_back(static_cast<char>(text.size()));
    } else {
        frame.push_back(126);
        frame.push_back(static_cast<char>(text.size() >> 8U));
        frame.push_back(static_cast<char>(text.size()));
    }
    return writeAll(frame + text);
}

bool WebSocketServer::receive(std::string& text) {
    constexpr unsigned kText = 0x81;
    std::array<unsigned char, 2> head{};
    if (!readBytes(head.data(), 2) || head[0] != kText) return false;
    std::size_t length = head[1] & 0x7FU;
    if (length == 126) {
        if (!readBytes(head.data(), 2)) return false;
        length = static_cast<std::size_t>(head[0]) << 8U | head[1];
    }
    std::array<unsigned char, 4> mask{};
    text.resize(length);
    if (!readBytes(mask.data(), 4) || !readBytes(reinterpret_cast<unsigned char*>(text.data()), length)) return false;
    for (std::size_t i = 0; i < length; ++i) text[i] = static_cast<char>(text[i] ^ mask[i % 4]);
    return true;
}

}  // namespace tactooth::test
