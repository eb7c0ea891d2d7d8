// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The surgery around the patient, as smooth surfaces reflect it: a bright ceiling with a row of lights, two tall
// windows, a dim floor with a dark line of furniture, and the operating light as a bright disc. `blur` 0..1 is the width
// of the reflection.
vec3 environment(vec3 direction, float blur) {
    float soft = 0.06 + 0.5 * blur;
    float ceiling = smoothstep(-soft, 0.55 + soft, direction.z);
    float furniture = direction.z * direction.z / (0.03 + 0.6 * blur + direction.z * direction.z);
    vec3 room = mix(groundColour.rgb, skyColour.rgb, ceiling) * (0.6 + furniture);
    float window = smoothstep(0.66 - soft, 0.66 + soft, abs(direction.x * 0.8 + direction.y * 0.6)) *
                   smoothstep(-0.30 - soft, 0.10 + soft, direction.z);
    float lights = smoothstep(0.22 + soft, 0.22 - soft, abs(direction.y - 0.25)) *
                   smoothstep(0.35 - soft, 0.60 + soft, direction.z);
    float lamp = smoothstep(0.010 + 0.20 * soft, 0.010 - 0.10 * soft, 1.0 - dot(direction, toKey.xyz));
    return room + skyColour.rgb * (2.4 * window + 1.6 * lights) + keyColour.rgb * (lamp * 0.55 / (0.06 + soft));
}

// The patient's bib (along y) in the operating light, below the mouth. Instruments and mirrors reflect it; lips and
// cheeks hide it from the teeth.
vec3 bib(vec3 direction, float blur) {
    float soft = 0.06 + 0.5 * blur;
    float below = smoothstep(0.30 - soft, 0.55 + soft, -direction.z);
    float between = smoothstep(0.50 + soft, 0.32 - soft, abs(direction.x));
    return keyColour.rgb * vec3(0.46, 0.52, 0.56) * (below * between);
}
