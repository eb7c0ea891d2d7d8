// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

#include "view/camera/camera.h"

namespace tactooth {

/// The frame and title of the small picture in the corner of the tooth view. A click turns the large picture to that
/// view.
class SecondViewFrame final : public QAbstractButton {
    Q_OBJECT

public:
    explicit SecondViewFrame(QWidget* parent);

    /// Moves the frame to the small picture in a view of this size, pixels.
    void fitTo(ImageSize picture);

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace tactooth
