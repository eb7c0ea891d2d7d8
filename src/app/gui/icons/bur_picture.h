// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QPixmap>
#include <map>
#include <string>
#include <utility>

#include "instruments/bur_shape.h"

namespace tactooth {

/// Part of a bur that its picture shows, mm above the tip: the longest head and the neck behind it.
inline constexpr double kBurPictureLength = 9.5;

/// Side view of a bur that stands on its tip, on a clear ground. All pictures of one height have one scale, so that
/// sizes can be compared. Needs no OpenGL. Takes some milliseconds.
[[nodiscard]] QImage drawBur(const Bur& bur, QSize size);

/// The pictures of the catalogue's burs. Each is drawn once.
class BurPictures {
public:
    /// Of burs that are `size` pixels large, on a screen with `ratio` device pixels for each of them.
    void setSize(QSize size, double ratio);
    [[nodiscard]] QSize size() const { return size_; }
    /// Null until it was drawn.
    [[nodiscard]] const QPixmap* find(const std::string& number) const;
    void draw(const BurSpec& spec);

private:
    QSize size_;
    double ratio_ = 1;
    std::map<std::string, QPixmap> drawn_;
};

}  // namespace tactooth
