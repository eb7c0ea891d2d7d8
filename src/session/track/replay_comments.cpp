// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/track/replay_comments.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/assert.h"
#include "session/track/messages.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostFileBytes = std::size_t{64} << 20;
constexpr double kLastTime = 1e6;  // s: longer than any session

/// At most kMostBytes, and no part of a character.
std::string shortened(std::string text) {
    if (text.size() <= ReplayComments::kMostBytes) return text;
    std::size_t end = ReplayComments::kMostBytes;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
    text.resize(end);
    return text;
}

Expected<std::vector<ReplayComment>> parse(std::string_view text, const std::string& file) {
    const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
    if (!json.is_object() || !json.contains("comments") || !json["comments"].is_array()) {
        return unexpected(msg::kCommentsJson, file);
    }
    if (json["comments"].size() > ReplayComments::kMost) {
        return unexpected(msg::kCommentsTooMany, file, ReplayComments::kMost);
    }
    std::vector<ReplayComment> comments;
    for (const Json& entry : json["comments"]) {
        const bool isWhole = entry.is_object() && entry.contains("time_s") && entry["time_s"].is_number() &&
                             entry.contains("text") && entry["text"].is_string();
        const double time = isWhole ? entry["time_s"].get<double>() : -1;
        if (!(time >= 0 && time <= kLastTime)) return unexpected(msg::kCommentsEntry, file, comments.size() + 1);
        comments.push_back({time, shortened(entry["text"].get<std::string>())});
    }
    return comments;
}

void sort(std::vector<ReplayComment>& comments) { std::ranges::stable_sort(comments, {}, &ReplayComment::time); }

}  // namespace

Expected<ReplayComments> ReplayComments::open(const std::filesystem::path& recording) {
    ReplayComments comments(recording.native() + std::string(kCommentsEnding));
    std::error_code unknown;  // readFile reports what is wrong
    if (!std::filesystem::exists(comments.file_, unknown) && !unknown) return comments;
    const Expected<FileBytes> bytes = readFile(comments.file_, kMostFileBytes);
    if (!bytes) return Unexpected{bytes.error()};
    Expected<std::vector<ReplayComment>> parsed = parse(bytes->text(), displayName(comments.file_));
    if (!parsed) return Unexpected{parsed.error()};
    comments.comments_ = std::move(*parsed);
    sort(comments.comments_);
    return comments;
}

Expected<void> ReplayComments::add(ReplayComment comment) {
    TACTOOTH_ASSERT(comment.time >= 0 && comment.time <= kLastTime);
    if (comments_.size() >= kMost) return unexpected(msg::kCommentsTooMany, displayName(file_), kMost - 1);
    std::vector<ReplayComment> comments = comments_;
    comments.push_back({comment.time, shortened(std::move(comment.text))});
    sort(comments);
    return replaceBy(std::move(comments));
}

Expected<void> ReplayComments::remove(std::size_t index) {
    TACTOOTH_ASSERT(index < comments_.size());
    std::vector<ReplayComment> comments = comments_;
    comments.erase(comments.begin() + static_cast<std::ptrdiff_t>(index));
    return replaceBy(std::move(comments));
}

Expected<void> ReplayComments::replaceBy(std::vector<ReplayComment> comments) {
    Json list = Json::array();
    for (const ReplayComment& comment : comments) list.push_back({{"time_s", comment.time}, {"text", comment.text}});
    const Json json = {{"format", "Tactooth comments"}, {"comments", list}};
    const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    if (auto written = writeFile(file_, text); !written) return written;
    comments_ = std::move(comments);
    return {};
}

}  // namespace tactooth
