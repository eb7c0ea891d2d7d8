// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// A body of tinted glass inside another one. The light at the eye shows its form, the tint shows its depth.
in vec3 worldPosition;
in vec3 worldNormal;
in vec4 surfaceAppearance;
in float appearanceOpacity;

uniform sampler2D shellDepth;  // of the surrounding body
uniform float cover;           // factor on the opacity of the appearance

layout(location = 0) out vec4 fragment;

const float kDeep = 2.5;  // mm: the depth of a typical cavity, where the tint has changed by two thirds

/// Depth below the surface of the surrounding body, along the line of sight, mm; 0 in front of that surface.
float depthBelow() {
    float depth = texelFetch(shellDepth, ivec2(gl_FragCoord.xy), 0).r;
    if (depth >= gl_FragCoord.z) return 0.0;
    vec4 surface = clipToWorld * vec4(2.0 * vec3(gl_FragCoord.xy * pictureSize.zw, depth) - 1.0, 1.0);
    return distance(surface.xyz / surface.w, worldPosition);
}

void main() {
    vec3 toEye = normalize(eye.xyz - worldPosition);
    float squareOn = abs(dot(normalize(worldNormal), toEye));
    float edgeOn = 1.0 - squareOn;
    // Light comes from the eye, and a little from above: floors and walls differ in brightness from every viewpoint.
    float shade = 0.45 + 0.45 * squareOn + 0.10 * abs(normalize(worldNormal).z);
    float deep = 1.0 - exp(-depthBelow() / kDeep);
    vec3 tint = surfaceAppearance.rgb * mix(vec3(1.0), vec3(0.10, 0.24, 0.45), deep);
    // Glass is darkest at grazing view.
    float opacity = mix(appearanceOpacity, 1.0, 0.6 * edgeOn * edgeOn * step(appearanceOpacity, 0.999)) * cover;
    fragment = vec4(toSrgb(tint * shade) * opacity, opacity);
}
