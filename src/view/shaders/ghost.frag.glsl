// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// A body of tinted glass inside another one. The light at the eye shows its form, the tint shows its depth. Opaque
// parts are lines on the surface of the surrounding body: they keep their colour.
in vec3 worldPosition;
in vec3 worldNormal;
in vec4 surfaceAppearance;
in float appearanceOpacity;
in float appearanceHidden;

uniform sampler2D shellDepth;  // of the surrounding body
uniform float cover;           // factor on the opacity of glass
uniform int isNear;            // the near layer has no lines, and one colour: the sides that are seen through tooth
uniform vec4 stepColours[GHOST_STEPS];  // linear
uniform float stepSize;                 // mm

layout(location = 0) out vec4 fragment;

// A line lies half in the surface, and deeper at its edges when seen at a grazing angle.
const float kOnSurface = 0.15, kHidden = 0.30;  // mm

const float kDeep = 2.0;  // mm: from here to twice as deep the opacity falls
const float kDeepCover = 0.5;

/// Depth below the surface of the surrounding body, along the line of sight, mm; 0 in front of that surface.
float depthBelow() {
    float depth = texelFetch(shellDepth, ivec2(gl_FragCoord.xy), 0).r;
    if (depth >= gl_FragCoord.z) return 0.0;
    vec4 surface = clipToWorld * vec4(2.0 * vec3(gl_FragCoord.xy * pictureSize.zw, depth) - 1.0, 1.0);
    return distance(surface.xyz / surface.w, worldPosition);
}

/// Steps with narrow transitions: the border between two of them is a line of equal depth.
vec3 tintAt(float depth) {
    const float kTransition = 0.2;  // of a step
    float steps = depth / stepSize;
    int index = min(int(steps), GHOST_STEPS - 1);
    float share = smoothstep(1.0 - kTransition, 1.0, fract(steps));
    return mix(stepColours[index].rgb, stepColours[min(index + 1, GHOST_STEPS - 1)].rgb, share);
}

void main() {
    bool isLine = appearanceOpacity > 0.999;
    if (isLine && isNear != 0) discard;
    float below = depthBelow();
    vec3 toEye = normalize(eye.xyz - worldPosition);
    float squareOn = abs(dot(normalize(worldNormal), toEye));
    float edgeOn = 1.0 - squareOn;
    // Light comes from the eye, and a little from above: floors and walls differ in brightness from every viewpoint.
    float shade = 0.45 + 0.45 * squareOn + 0.10 * abs(normalize(worldNormal).z);
    if (isLine) {
        float opacity = mix(1.0, appearanceHidden, smoothstep(kOnSurface, kHidden, below));
        if (opacity < 0.02) discard;
        fragment = vec4(toSrgb(surfaceAppearance.rgb * shade) * opacity, opacity);
        return;
    }
    // Glass is darkest at grazing view. What lies deep is mostly seen from the side, through tooth that stays.
    float deepCover = mix(1.0, kDeepCover, smoothstep(kDeep, 2.0 * kDeep, below));
    float opacity = mix(appearanceOpacity, 1.0, 0.6 * edgeOn * edgeOn) * cover * deepCover;
    vec3 tint = isNear != 0 ? surfaceAppearance.rgb : tintAt(below);
    fragment = vec4(toSrgb(tint * shade) * opacity, opacity);
}
