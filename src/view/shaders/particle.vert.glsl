// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
layout(location = 0) in vec4 ball;    // world centre, radius; mm
layout(location = 1) in vec4 paint;   // sRGB, opacity

uniform float pixelsPerRadian;  // picture height / (2 tan(field of view / 2))

out vec4 colour;
out float gl_ClipDistance[2];

void main() {
    gl_Position = worldToClip * vec4(ball.xyz, 1.0);
    gl_PointSize = max(2.0 * ball.w * pixelsPerRadian / gl_Position.w, 1.0);
    colour = paint;
    gl_ClipDistance[0] = dot(clipPlane, vec4(ball.xyz, 1.0));
    gl_ClipDistance[1] = 1.0;
}
