// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in uint appearanceMix;  // first, second, share of the second in 255ths; one byte each

uniform mat4 objectToWorld;
uniform vec4 appearances[2 * MAX_APPEARANCES];  // (linear colour, roughness), (metalness, translucency, wetness, grain)
#if RICH
uniform float opacities[MAX_APPEARANCES];
out float appearanceOpacity;
#endif
#ifdef GHOST_STEPS
uniform float hiddenOpacities[MAX_APPEARANCES];
out float appearanceHidden;
#endif
uniform int appearanceCount;
uniform float secondAbove;  // object frame, mm: the height above which the second appearance counts alone; 0: none
uniform int sectioned;  // 0: the section does not cut this object

out vec3 worldPosition;
out vec3 worldNormal;
out vec3 objectPosition;
out vec3 noisePlace;
out vec4 surfaceAppearance;    // linear colour, roughness
out vec4 materialAppearance;   // metalness, translucency, wetness, grain
out float gl_ClipDistance[2];

void main() {
    vec4 world = objectToWorld * vec4(position, 1.0);
    worldPosition = world.xyz;
    worldNormal = mat3(objectToWorld) * normal.xyz;
    objectPosition = position;
    int first = 2 * min(int(appearanceMix & 255u), appearanceCount - 1);
    int second = 2 * min(int((appearanceMix >> 8) & 255u), appearanceCount - 1);
    if (secondAbove != 0.0 && position.z > secondAbove) first = second = 2 * min(1, appearanceCount - 1);
    float share = float((appearanceMix >> 16) & 255u) / 255.0;
    surfaceAppearance = mix(appearances[first], appearances[second], share);
    materialAppearance = mix(appearances[first + 1], appearances[second + 1], share);
#ifdef MACHINED
    noisePlace = position;
#else
    noisePlace = noisePlaceOf(position);
#endif
#ifdef LIQUIDS
    addLiquids(world.xyz, surfaceAppearance, materialAppearance);
#endif
    gl_Position = worldToClip * world;
    gl_ClipDistance[0] = dot(clipPlane, world);
    // Mesa's software renderer clips by every distance that is written, also where its plane is switched off.
    gl_ClipDistance[1] = sectioned != 0 ? dot(section, world) : 1.0;
#if RICH
    appearanceOpacity = mix(opacities[first / 2], opacities[second / 2], share);
#endif
#ifdef GHOST_STEPS
    appearanceHidden = mix(hiddenOpacities[first / 2], hiddenOpacities[second / 2], share);
#endif
}
