// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Glass: what hides the line of sight (Scene::sight) turns to glass, so that the eye sees through it.
const float kSoftEdge = 0.35;   // of the radius: the glass fades into the solid body
const float kSoftDepth = 0.2;   // mm behind the place: there glass begins, and is complete at the place
const float kWidening = 0.3;    // mm by which the window widens for each mm in front of the place, ...
const float kMostWidening = 3.0;  // ... at most; a handle far in front shows more of what is behind it

/// 1: the point of the body at this pixel is glass, 0: it is solid. `above`: the height where the body's glass begins; a
/// body that has any belongs to the line itself, and does not widen the window.
float glassShare(float above) {
    float perMm = sightReach.w;
    float before = sightReach.x - 1.0 / gl_FragCoord.w;  // mm in front of the place
    if (perMm <= 0.0 || before <= -kSoftDepth) return 0.0;
    vec2 line = sightEnds.zw - sightEnds.xy;
    float reach = length(line);
    vec2 along = reach > 0.01 ? line / reach : vec2(0.0, 1.0);
    vec2 here = gl_FragCoord.xy - sightEnds.xy;
    float u = dot(here, along);
    float v = dot(here, vec2(-along.y, along.x));
    float wider = above > -1e8 ? 0.0 : perMm * clamp(kWidening * before, 0.0, kMostWidening);
    float aside = sightReach.y + wider;
    float beyond = u > reach ? (u - reach) / (sightReach.z + wider) : min(u, 0.0) / aside;
    return smoothstep(-kSoftDepth, 0.0, before) * (1.0 - smoothstep(1.0, 1.0 + kSoftEdge, length(vec2(v / aside, beyond))));
}

/// Of glass: its outline is a thin line, whatever the distance; faces that the eye sees edge-on are a little darker.
/// All walls of a shank are edge-on where one looks along it, around what must be seen: it has only a faint outline.
float glassOpacity(float squareOn, float slope, float above) {
    const float kFace = 0.10, kEdge = 0.22, kOutline = 0.45, kOfShank = 0.2;
    float edgeOn = 1.0 - squareOn;
    float outline = 1.0 - smoothstep(0.6, 1.8, squareOn / max(slope, 1e-3));
    float line = kEdge * edgeOn * edgeOn * edgeOn + kOutline * outline;
    return kFace + line * (above > -1e8 ? kOfShank : 1.0);
}
