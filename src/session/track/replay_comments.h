// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/util/expected.h"

namespace tactooth {

/// A comment that someone has pinned to a moment of a recorded session.
struct ReplayComment {
    double time = 0;  ///< s since the session began
    std::string text;

    friend bool operator==(const ReplayComment&, const ReplayComment&) = default;
};

/// Ending that the name of a recording gets for the file with its comments.
inline constexpr std::string_view kCommentsEnding = ".comments.json";

/// The comments on a recording. They are in a file beside it, so that the recording itself stays as it was made.
class ReplayComments {
public:
    static constexpr std::size_t kMost = 10'000;
    static constexpr std::size_t kMostBytes = 4'000;  ///< of one text; the rest is left out

    /// Reads the comments on a recording; none if the file does not exist. Fails with one sentence if it is damaged.
    [[nodiscard]] static Expected<ReplayComments> open(const std::filesystem::path& recording);

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    /// By rising time.
    [[nodiscard]] const std::vector<ReplayComment>& all() const { return comments_; }

    // Each of these writes the file. If that fails, the comments stay as they were.
    [[nodiscard]] Expected<void> add(ReplayComment comment);
    [[nodiscard]] Expected<void> remove(std::size_t index);

private:
    explicit ReplayComments(std::filesystem::path file) : file_(std::move(file)) {}
    [[nodiscard]] Expected<void> replaceBy(std::vector<ReplayComment> comments);

    std::filesystem::path file_;
    std::vector<ReplayComment> comments_;
};

}  // namespace tactooth
