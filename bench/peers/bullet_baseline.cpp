// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <btBulletCollisionCommon.h>

#include <algorithm>

#include "peers/peer.h"

namespace tactooth::bench {
namespace {

btVector3 toBullet(const Vec3& v) {
    return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

std::unique_ptr<btTriangleMesh> trianglesOf(const TriangleMesh& mesh) {
    auto triangles = std::make_unique<btTriangleMesh>();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        triangles->addTriangle(toBullet(mesh.corner(t, 0)), toBullet(mesh.corner(t, 1)), toBullet(mesh.corner(t, 2)));
    }
    return triangles;
}

/// A shape with the triangles that it refers to.
struct OwnedShape {
    std::unique_ptr<btTriangleMesh> triangles;
    std::unique_ptr<btCollisionShape> shape;
};

OwnedShape bvhOf(const TriangleMesh& mesh) {
    OwnedShape owned{trianglesOf(mesh), nullptr};
    owned.shape = std::make_unique<btBvhTriangleMeshShape>(owned.triangles.get(), true);
    owned.shape->setMargin(0);
    return owned;
}

OwnedShape gimpactOf(const TriangleMesh& mesh) {
    OwnedShape owned{trianglesOf(mesh), nullptr};
    auto shape = std::make_unique<btGImpactMeshShape>(owned.triangles.get());
    shape->setMargin(0);
    shape->updateBound();
    owned.shape = std::move(shape);
    return owned;
}

OwnedShape hullOf(const TriangleMesh& mesh) {
    auto shape = std::make_unique<btConvexHullShape>();
    for (const Vec3f& v : mesh.vertices) shape->addPoint(toBullet(v.cast<double>()), false);
    shape->recalcLocalAabb();
    shape->setMargin(0);
    return {nullptr, std::move(shape)};
}

/// Takes every contact and keeps the deepest.
struct Deepest final : btManifoldResult {
    Deepest(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b) : btManifoldResult(a, b) {}
    btScalar distance = 1;
    void addContactPoint(const btVector3&, const btVector3&, btScalar depth) override {
        distance = std::min(distance, depth);
    }
};

class BulletBaseline final : public Baseline {
public:
    BulletBaseline(std::string name, std::string gives, OwnedShape tooth, OwnedShape bur)
        : name_(std::move(name)),
          gives_(std::move(gives)),
          dispatcher_(&configuration_),
          toothShape_(std::move(tooth)),
          burShape_(std::move(bur)) {
        btGImpactCollisionAlgorithm::registerAlgorithm(&dispatcher_);
        tooth_.setCollisionShape(toothShape_.shape.get());
        bur_.setCollisionShape(burShape_.shape.get());
    }

    [[nodiscard]] std::string name() const override { return name_; }
    [[nodiscard]] std::string gives() const override { return gives_; }

    bool tick(const Pose& deviceInTooth) override {
        const Quat& q = deviceInTooth.rotation;
        bur_.setWorldTransform(btTransform(btQuaternion(static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()),
                                                        static_cast<btScalar>(q.z()), static_cast<btScalar>(q.w())),
                                           toBullet(deviceInTooth.position)));
        // As btCollisionWorld::contactPairTest does, which however knows no way for two GImpact meshes.
        const btCollisionObjectWrapper a(nullptr, tooth_.getCollisionShape(), &tooth_, tooth_.getWorldTransform(), -1,
                                         -1);
        const btCollisionObjectWrapper b(nullptr, bur_.getCollisionShape(), &bur_, bur_.getWorldTransform(), -1, -1);
        Deepest deepest(&a, &b);
        btCollisionAlgorithm* way = dispatcher_.findAlgorithm(&a, &b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
        way->processCollision(&a, &b, btDispatcherInfo(), &deepest);
        way->~btCollisionAlgorithm();
        dispatcher_.freeCollisionAlgorithm(way);
        return deepest.distance < 0;
    }

private:
    std::string name_, gives_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    OwnedShape toothShape_, burShape_;
    btCollisionObject tooth_, bur_;
};

}  // namespace

void addBulletPeers(const Pair& pair, Peers& peers) {
    peers.push_back(std::make_unique<BulletBaseline>("Bullet convex bur, margin 0, all", "per triangle",
                                                     bvhOf(pair.tooth), hullOf(pair.burHull)));
    peers.push_back(std::make_unique<BulletBaseline>("Bullet GImpact mesh-mesh, all", "a guess", gimpactOf(pair.tooth),
                                                     gimpactOf(pair.bur)));
}

}  // namespace tactooth::bench
