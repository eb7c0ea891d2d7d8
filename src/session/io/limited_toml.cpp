// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/limited_toml.h"

#include <algorithm>
#include <string>

#include "geometry/files/file_bytes.h"
#include "geometry/util/display_text.h"
#include "geometry/util/messages.h"
#include "session/io/messages.h"

namespace tactooth {
namespace {

/// Scans a text once, without recursion, and counts what would make the parser recurse deeply or allocate much. It
/// detects strings and comments as TOML 1.0 does. Where it errs the text is no TOML, and the parser stops there too.
class TomlLimiter {
public:
    explicit TomlLimiter(std::string_view text) : text_(text) {}

    /// The exceeded limit, as part of a sentence; empty if there is none.
    Message fault() {
        for (std::size_t end = 0; end < text_.size(); ++line_) {
            const std::size_t begin = end;
            end = std::min(text_.find('\n', begin), text_.size() - 1) + 1;
            if (end - begin > kTomlLimits.lineBytes) return {msg::kTomlLine, kTomlLimits.lineBytes};
        }
        line_ = 1;
        while (at_ < text_.size() && fault_.empty()) step();
        return fault_;
    }

    /// The line of the fault.
    [[nodiscard]] int line() const { return line_; }

private:
    void step() {
        switch (text_[at_]) {
            case '\n':
                ++line_;
                parts_ = 1;
                break;
            case '#':
                at_ = std::min(text_.find('\n', at_), text_.size());
                return;
            case '"':
            case '\'':
                skipString();
                return;
            case '[':
            case '{':
                count(++depth_ > kTomlLimits.nesting, msg::kTomlNesting, kTomlLimits.nesting);
                countValue();
                break;
            case ']':
            case '}':
                depth_ = std::max(0, depth_ - 1);
                parts_ = 1;
                break;
            case '=':
            case ',':
                countValue();
                break;
            case '.':
                count(++parts_ > kTomlLimits.keyParts, msg::kTomlKeyParts, kTomlLimits.keyParts);
                break;
            default:
                break;
        }
        ++at_;
    }

    void count(bool isTooMuch, const MessageText& what, std::size_t most) {
        if (isTooMuch && fault_.empty()) fault_ = {what, most};
    }

    void countValue() {
        parts_ = 1;
        count(++values_ > kTomlLimits.values, msg::kTomlValues, kTomlLimits.values);
    }

    void skipString() {
        const char quote = text_[at_];
        const bool isLong = text_.substr(at_, 3) == std::string(3, quote);
        at_ += isLong ? 3 : 1;
        for (; at_ < text_.size(); ++at_) {
            const char letter = text_[at_];
            if (letter == '\n') {
                if (!isLong) return;  // a string of one line that does not end
                ++line_;
            } else if (letter == '\\' && quote == '"') {
                if (at_ + 1 < text_.size() && text_[at_ + 1] != '\n') ++at_;
            } else if (letter == quote && (!isLong || text_.substr(at_, 3) == std::string(3, quote))) {
                at_ += isLong ? 3 : 1;
                for (int i = 0; isLong && i < 2 && at_ < text_.size() && text_[at_] == quote; ++i) ++at_;
                return;
            }
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
    int depth_ = 0;
    int parts_ = 1;  // of the present key or number
    std::size_t values_ = 0;
    Message fault_;
};

Unexpected refusal(std::string_view name, long line, const Message& what) {
    return unexpected(msg::kAtLine, name, line, what);
}

/// The parser's message, as part of a sentence.
std::string asClause(std::string_view description) {
    constexpr std::size_t kLongest = 200;  // characters
    std::string clause = displayShort(description, kLongest);
    clause.erase(clause.find_last_not_of(" .") + 1);
    return clause;
}

}  // namespace

Expected<toml::table> parseToml(std::string_view text, std::string_view name) {
    if (text.size() > kTomlLimits.bytes) {
        return unexpected(msg::kTomlTooLarge, name, kTomlLimits.bytes);
    }
    TomlLimiter guard(text);
    if (const Message fault = guard.fault(); !fault.empty()) return refusal(name, guard.line(), fault);
    try {
        return toml::parse(text);
    } catch (const toml::parse_error& error) {
        return refusal(name, static_cast<long>(error.source().begin.line),
                       {msg::kNotToml, asClause(error.description())});
    }
}

Expected<toml::table> readToml(const std::filesystem::path& file) {
    const Expected<FileBytes> bytes = readFile(file, kTomlLimits.bytes);
    if (!bytes) return Unexpected{bytes.error()};
    return parseToml(bytes->text(), displayName(file));
}

}  // namespace tactooth
