// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The place of a point of an object (mm) in the noise texture. The noise repeats only after a third of a tooth, and it
// is turned against the axes of the object, along which surfaces run that would show the repetition.
const float kNoiseTile = 3.3;  // mm: a texel is a tenth of a millimetre
const mat3 kNoiseTurn = mat3(0.7384, 0.5317, -0.4149, -0.3672, 0.8350, 0.4098, 0.5655, -0.1503, 0.8110);
vec3 noisePlaceOf(vec3 point) { return kNoiseTurn * point / kNoiseTile; }
