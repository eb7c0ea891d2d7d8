// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "geometry/util/assert.h"

namespace tactooth {

/// A language in which the program speaks to people.
enum class Language { English, Japanese };

/// One sentence, or one part of a sentence, in every language: a row of a layer's catalogue (messages.h). %1 to %9 are
/// the places for the arguments. Both languages have the same places, and both end in a full stop or neither does; the
/// compiler checks this.
struct MessageText {
    std::string_view id;  ///< stable: it names the message in tests and logs
    std::string_view english, japanese;

    consteval MessageText(std::string_view newId, std::string_view newEnglish, std::string_view newJapanese)
        : id(newId), english(newEnglish), japanese(newJapanese) {
        if (newId.empty() || newEnglish.empty() || newJapanese.empty()) throw "a row has an id and both languages";
        if (placesIn(newEnglish) != placesIn(newJapanese)) throw "the languages have different places";
        if (newEnglish.ends_with('.') != newJapanese.ends_with("。")) throw "one language lacks the full stop";
    }

    [[nodiscard]] constexpr std::string_view in(Language language) const {
        return language == Language::English ? english : japanese;
    }

    /// Bit i is set where the text has the place %i.
    [[nodiscard]] static constexpr unsigned placesIn(std::string_view text) {
        unsigned places = 0;
        for (std::size_t i = 0; i + 1 < text.size(); ++i) {
            if (isPlace(text, i)) places |= 1U << (text[i + 1] - '0');
        }
        return places;
    }
    [[nodiscard]] static constexpr bool isPlace(std::string_view text, std::size_t at) {
        return text[at] == '%' && at + 1 < text.size() && text[at + 1] >= '1' && text[at + 1] <= '9';
    }
};

/// A row of a catalogue with its arguments: names, numbers, or other messages. It is put into words when a person reads
/// it, in that person's language.
class Message {
public:
    Message() = default;

    /// `text` lives as long as the program, as the rows of the catalogues do. An argument is a text, a whole number, a
    /// row, or a message. There is one for each place of the row.
    template <class... Arguments>
    Message(const MessageText& text, Arguments&&... arguments)
        : text_(&text), arguments_{argument(std::forward<Arguments>(arguments))...} {
        TACTOOTH_ASSERT(MessageText::placesIn(text.english) == (1U << (sizeof...(Arguments) + 1)) - 2);
    }

    /// Words that stay as they are in every language: a name, a number, the report of a library.
    [[nodiscard]] static Message verbatim(std::string words) {
        Message message;
        message.words_ = std::move(words);
        return message;
    }
    /// Words of a data file that has them in both languages, as the title of a material.
    [[nodiscard]] static Message bilingual(std::string english, std::string japanese) {
        Message message = verbatim(std::move(english));
        message.japanese_ = std::move(japanese);
        return message;
    }

    [[nodiscard]] std::string in(Language language) const;

    /// The id of the row; empty for other words.
    [[nodiscard]] std::string_view id() const { return text_ != nullptr ? text_->id : std::string_view(); }
    /// Whether it is this row, or has it among its arguments at any depth.
    [[nodiscard]] bool contains(const MessageText& text) const;
    [[nodiscard]] bool empty() const { return text_ == nullptr && words_.empty(); }

    /// Puts `words` in the place of the argument %1.
    void replaceFirst(std::string words) { arguments_.at(0) = verbatim(std::move(words)); }

private:
    template <class T>
    static Message argument(T&& value) {
        using Plain = std::remove_cvref_t<T>;
        if constexpr (std::derived_from<Plain, Message> || std::same_as<Plain, MessageText>) {
            return Message(std::forward<T>(value));
        } else if constexpr (std::integral<Plain>) {
            static_assert(!std::same_as<Plain, bool> && !std::same_as<Plain, char>, "give a text or a number");
            return verbatim(std::to_string(value));
        } else {
            return verbatim(std::string(std::forward<T>(value)));
        }
    }

    const MessageText* text_ = nullptr;
    std::string words_;
    std::string japanese_;  // of words_; empty: the same
    std::vector<Message> arguments_;
};

}  // namespace tactooth
