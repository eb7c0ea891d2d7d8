// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <filesystem>
#include <string>

#include "geometry/util/expected.h"
#include "view/render/image.h"

namespace tactooth {

/// Many small pictures on one sheet, in rows and columns, with a caption below each.
class ContactSheet {
public:
    ContactSheet(int columns, int rows, ImageSize tile);

    void place(int column, int row, const Image& picture, const std::string& word);
    [[nodiscard]] Expected<void> save(const std::filesystem::path& png) const;

private:
    ImageSize tile_;
    QImage sheet_;
};

}  // namespace tactooth
