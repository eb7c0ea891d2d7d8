// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/gl/drawable.h"

#include <algorithm>

namespace tactooth {

bool Drawable::isTransparent() const {
    return std::any_of(object->appearances.begin(), object->appearances.end(),
                       [](const Appearance& appearance) { return appearance.opacity < 1; });
}

bool Drawable::cullsBackFaces(bool inSection) const {
    return object->closed && (!inSection || !object->sectioned || object->capAppearance);
}

Mat4 matrixOf(const Pose& pose) {
    Mat4 matrix = Mat4::Identity();
    matrix.topLeftCorner<3, 3>() = pose.rotation.toRotationMatrix();
    matrix.topRightCorner<3, 1>() = pose.position;
    return matrix;
}

Mat4 objectToWorld(const SceneObject& object) {
    const Pose turned{Vec3::Zero(), Quat(Eigen::AngleAxisd(object.spin, Vec3::UnitZ()))};
    return matrixOf(object.objectInWorld * turned);
}

Box3 boxOf(const Drawable& drawable, const Mat4& worldToFrame) {
    return transformedBox(drawable.buffers->box(), worldToFrame * drawable.objectToWorld);
}

Box3 transformedBox(const Box3& box, const Mat4& toFrame) {
    Box3 result;
    if (box.isEmpty()) return result;
    for (int i = 0; i < 8; ++i) {
        const Vec3 corner = box.corner(static_cast<Box3::CornerType>(i));
        result.extend((toFrame * corner.homogeneous()).head<3>());
    }
    return result;
}

}  // namespace tactooth
