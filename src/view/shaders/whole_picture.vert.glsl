// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// One triangle that covers the picture, at the far end of the depth range. No clip plane clips it.
out float gl_ClipDistance[2];

void main() {
    gl_ClipDistance[0] = gl_ClipDistance[1] = 1.0;
    vec2 corner = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
    gl_Position = vec4(2.0 * corner - 1.0, 1.0, 1.0);
}
