// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
layout(location = 0) in vec4 ball;    // world centre, radius; mm
layout(location = 1) in vec4 paint;   // sRGB, opacity
layout(location = 2) in vec3 streak;  // world, mm; it ends at the centre

uniform float pixelsPerRadian;  // picture height / (2 tan(field of view / 2))

out vec4 colour;
flat out vec3 shape;  // pixels: half the streak, right and down in the picture; radius
out float gl_ClipDistance[2];

void main() {
    vec4 middle = vec4(ball.xyz - 0.5 * streak, 1.0);
    gl_Position = worldToClip * middle;
    vec4 end = worldToClip * vec4(ball.xyz, 1.0);
    vec2 half_ = 0.5 * pictureSize.xy * (end.xy / max(end.w, 1e-3) - gl_Position.xy / max(gl_Position.w, 1e-3));
    float radius = max(ball.w * pixelsPerRadian / gl_Position.w, 0.5);
    float length_ = length(half_);
    shape = vec3(half_.x, -half_.y, radius);
    gl_PointSize = 2.0 * (radius + length_);
    colour = vec4(paint.rgb, paint.a * radius / (radius + 0.6 * length_));
    gl_ClipDistance[0] = dot(clipPlane, middle);
    gl_ClipDistance[1] = 1.0;
}
