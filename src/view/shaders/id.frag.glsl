// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Which object is visible at a pixel, by the rules of solid.frag, and how much of its light passes the glass before it.
in vec3 worldPosition;
in vec3 worldNormal;
in vec3 objectPosition;

uniform int object;       // its number, from 1 on
uniform int glassPhase;   // as in solid.frag
uniform float glassAbove;
uniform vec4 ball;        // world: centre, radius in mm
uniform vec4 mirrorPlane; // world: normal, offset; its glass is never see-through. Normal 0: there is none

layout(location = 0) out vec4 fragment;

void main() {
    float squareOn = abs(dot(normalize(worldNormal), normalize(eye.xyz - worldPosition)));
    float slope = fwidth(squareOn);
    bool onMirror = any(notEqual(mirrorPlane.xyz, vec3(0.0))) &&
                    abs(dot(mirrorPlane.xyz, worldPosition) - mirrorPlane.w) < 0.05 &&
                    dot(mirrorPlane.xyz, eye.xyz) > mirrorPlane.w;
    float glass = glassPhase != 0 && !onMirror && objectPosition.z > glassAbove ? glassShare(glassAbove) : 0.0;
    if (glassPhase != 0 && (glassPhase == 1) == (glass > 0.0)) discard;
    if (glassPhase == 2) {
        fragment = vec4(0.0, 0.0, 0.0, mix(1.0, glassOpacity(squareOn, slope, glassAbove), glass));
        return;
    }
    int part = objectPosition.z <= glassAbove ? 1 : 0;
    if (distance(worldPosition, ball.xyz) < ball.w) part += 2;
    fragment = vec4(float(object) / 255.0, float(part) / 255.0, 1.0, 1.0);
}
