// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in uint tag;

uniform mat4 objectToWorld;

out vec3 worldPosition;
out vec3 worldNormal;
out vec3 objectPosition;
flat out uint materialTag;
out float gl_ClipDistance[1];

void main() {
    vec4 world = objectToWorld * vec4(position, 1.0);
    worldPosition = world.xyz;
    worldNormal = mat3(objectToWorld) * normal.xyz;
    objectPosition = position;
    materialTag = tag;
    gl_Position = worldToClip * world;
    gl_ClipDistance[0] = dot(clipPlane, world);
}
