// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
layout(location = 0) in vec3 position;

uniform mat4 objectToClip;
uniform vec4 clipInObject;     // points on the negative side of these planes are clipped
uniform vec4 sectionInObject;

out float gl_ClipDistance[2];

void main() {
    gl_Position = objectToClip * vec4(position, 1.0);
    gl_ClipDistance[0] = dot(clipInObject, vec4(position, 1.0));
    gl_ClipDistance[1] = dot(sectionInObject, vec4(position, 1.0));
}
