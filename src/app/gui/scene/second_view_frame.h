// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

#include "view/camera/camera.h"

namespace tactooth {

/// The frame with a title around the small picture in the corner of the tooth's view. A click wants the large picture
/// to look from there.
class SecondViewFrame final : public QAbstractButton {
    Q_OBJECT

public:
    explicit SecondViewFrame(QWidget* parent);

    /// Stands where the picture is drawn in a view of this many pixels.
    void fitTo(ImageSize picture);

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace tactooth
