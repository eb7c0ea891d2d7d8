// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainterPath>
#include <QPolygonF>

#include "app/gui/input/viewport.h"
#include "instruments/mirror.h"

namespace tactooth {

/// The rim of a mirror's glass in the picture, pixels of a widget with so many pixels of the picture to one of its own.
/// Empty if the glass is seen from behind, or if a part of it is not before the eye.
[[nodiscard]] QPolygonF glassInPicture(const MirrorDisc& glass, const Viewport& picture, double pixelRatio);

/// What lies in a polygon, to clip by it.
[[nodiscard]] QPainterPath pathOf(const QPolygonF& polygon);

}  // namespace tactooth
