// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The surgery around the patient, as smooth surfaces reflect it: a bright ceiling, a dim floor, the operating light and
// two tall windows. `blur` 0..1 is the width of the reflection.
vec3 environment(vec3 direction, float blur) {
    float height = direction.z * 0.5 + 0.5;
    vec3 room = mix(groundColour.rgb * 0.55, skyColour.rgb, smoothstep(0.15 - 0.3 * blur, 0.95 + 0.3 * blur, height));
    float horizon = exp(-direction.z * direction.z / (0.02 + 0.3 * blur));
    room *= 1.0 - 0.45 * horizon;

    float towardLight = dot(direction, toKey.xyz);
    float soft = 0.012 + 0.30 * blur;
    float lamp = smoothstep(0.955 - soft, 0.955 + soft, towardLight) / (1.0 + 5.0 * blur);
    float azimuth = direction.x * 0.8 + direction.y * 0.6;
    float softWindow = 0.05 + 0.35 * blur;
    float window = smoothstep(0.62 - softWindow, 0.62 + softWindow, abs(azimuth)) *
                   smoothstep(-0.35 - blur, -0.05 + blur, direction.z) / (1.0 + 1.5 * blur);
    return room + keyColour.rgb * (2.2 * lamp) + skyColour.rgb * (1.15 * window);
}
