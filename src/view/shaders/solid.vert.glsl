// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in uint lookMix;  // first look, second look, share of the second in 255ths; a byte each

uniform mat4 objectToWorld;
uniform vec4 looks[2 * MAX_LOOKS];  // (linear colour, roughness), (metalness, translucency, wetness, grain)
#if RICH
uniform float opacities[MAX_LOOKS];
out float lookOpacity;
#endif
uniform int lookCount;

out vec3 worldPosition;
out vec3 worldNormal;
out vec3 objectPosition;
out vec4 surfaceLook;    // linear colour, roughness
out vec4 materialLook;   // metalness, translucency, wetness, grain
out float gl_ClipDistance[2];

void main() {
    vec4 world = objectToWorld * vec4(position, 1.0);
    worldPosition = world.xyz;
    worldNormal = mat3(objectToWorld) * normal.xyz;
    objectPosition = position;
    int first = 2 * min(int(lookMix & 255u), lookCount - 1);
    int second = 2 * min(int((lookMix >> 8) & 255u), lookCount - 1);
    float share = float((lookMix >> 16) & 255u) / 255.0;
    surfaceLook = mix(looks[first], looks[second], share);
    materialLook = mix(looks[first + 1], looks[second + 1], share);
    gl_Position = worldToClip * world;
    gl_ClipDistance[0] = dot(clipPlane, world);
    gl_ClipDistance[1] = dot(section, world);
#if RICH
    lookOpacity = mix(opacities[first / 2], opacities[second / 2], share);
#endif
}
