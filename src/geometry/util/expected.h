// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <variant>

#include "geometry/util/assert.h"
#include "geometry/util/message.h"

namespace tactooth {

/// Why something that depends on the outside world (a file, a device, a typed number) did not work: one complete
/// sentence for the user who has to correct it. It names the file and the position, what was expected, and the remedy.
struct Error : Message {
    using Message::Message;
    Error() = default;
    Error(Message message) : Message(std::move(message)) {}

    /// In English, as the commands print it.
    [[nodiscard]] std::string message() const { return in(Language::English); }
};

/// Wraps an Error for an Expected, like std::unexpected in C++23.
struct Unexpected {
    Error error;
};

template <class... Arguments>
[[nodiscard]] Unexpected unexpected(const MessageText& text, Arguments&&... arguments) {
    return {Error(text, std::forward<Arguments>(arguments)...)};
}
[[nodiscard]] inline Unexpected unexpected(Message message) { return {Error(std::move(message))}; }

/// A value or an Error. Member names follow std::expected (C++23). Unlike there, nothing refers into an Expected that
/// is about to end: `for (x : f()->parts)` would read freed memory, so that an unnamed one gives its value away
/// instead.
template <class T>
class [[nodiscard]] Expected {
public:
    Expected(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Expected(Unexpected failure) : state_(std::in_place_index<1>, std::move(failure.error)) {}

    [[nodiscard]] bool has_value() const { return state_.index() == 0; }
    explicit operator bool() const { return has_value(); }

    [[nodiscard]] T& value() & { return TACTOOTH_ASSERT(has_value()), *std::get_if<0>(&state_); }
    [[nodiscard]] const T& value() const& { return TACTOOTH_ASSERT(has_value()), *std::get_if<0>(&state_); }
    [[nodiscard]] T value() && { return TACTOOTH_ASSERT(has_value()), std::move(*std::get_if<0>(&state_)); }
    [[nodiscard]] T& operator*() & { return value(); }
    [[nodiscard]] const T& operator*() const& { return value(); }
    [[nodiscard]] T operator*() && { return std::move(*this).value(); }
    [[nodiscard]] T* operator->() & { return &value(); }
    [[nodiscard]] const T* operator->() const& { return &value(); }
    T* operator->() && = delete;
    const T* operator->() const&& = delete;

    [[nodiscard]] const Error& error() const { return TACTOOTH_ASSERT(!has_value()), *std::get_if<1>(&state_); }

private:
    std::variant<T, Error> state_;
};

/// Success without a value, or an Error.
template <>
class [[nodiscard]] Expected<void> {
public:
    Expected() = default;
    Expected(Unexpected failure) : error_(std::move(failure.error)), ok_(false) {}

    [[nodiscard]] bool has_value() const { return ok_; }
    explicit operator bool() const { return ok_; }
    [[nodiscard]] const Error& error() const { return TACTOOTH_ASSERT(!ok_), error_; }

private:
    Error error_;
    bool ok_ = true;
};

}  // namespace tactooth
