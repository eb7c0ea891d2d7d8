// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/message.h"

#include <algorithm>

namespace tactooth {

std::string Message::in(Language language) const {
    if (text_ == nullptr) return language == Language::Japanese && !japanese_.empty() ? japanese_ : words_;
    const std::string_view stop = language == Language::English ? "." : "。";
    const std::string_view text = text_->in(language);
    std::string sentence;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (!MessageText::isPlace(text, at)) {
            sentence += text[at];
            continue;
        }
        const auto place = static_cast<std::size_t>(text[++at] - '1');
        const Message& argument = arguments_.at(place);
        std::string words = argument.in(language);
        // A whole sentence at the end of another one brings its own full stop.
        const bool isSentence = argument.text_ != nullptr && words.ends_with(stop);
        if (isSentence && text.substr(at + 1).starts_with(stop)) words.resize(words.size() - stop.size());
        sentence += words;
    }
    return sentence;
}

bool Message::contains(const MessageText& text) const {
    return text_ == &text ||
           std::ranges::any_of(arguments_, [&](const Message& argument) { return argument.contains(text); });
}

}  // namespace tactooth
