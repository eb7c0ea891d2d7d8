// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision.h>

#include <limits>

#include "peers/peer.h"

namespace tactooth::bench {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<Model> modelOf(const TriangleMesh& mesh) {
    std::vector<fcl::Vector3d> vertices;
    std::vector<fcl::Triangle> triangles;
    for (const Vec3f& v : mesh.vertices) vertices.push_back(v.cast<double>());
    for (const Triangle& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
    auto model = std::make_shared<Model>();
    model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(vertices.size()));
    model->addSubModel(vertices, triangles);
    model->endModel();
    return model;
}

std::shared_ptr<fcl::Convexd> convexOf(const TriangleMesh& hull) {
    auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
    auto faces = std::make_shared<std::vector<int>>();
    for (const Vec3f& v : hull.vertices) vertices->push_back(v.cast<double>());
    for (const Triangle& t : hull.triangles) {
        faces->push_back(3);
        for (const std::uint32_t vertex : t) faces->push_back(static_cast<int>(vertex));
    }
    return std::make_shared<fcl::Convexd>(vertices, static_cast<int>(hull.triangles.size()), faces);
}

class FclBaseline final : public Baseline {
public:
    FclBaseline(std::string name, std::string gives, std::shared_ptr<const fcl::CollisionGeometryd> tooth,
                std::shared_ptr<const fcl::CollisionGeometryd> bur, bool allContacts)
        : name_(std::move(name)),
          gives_(std::move(gives)),
          tooth_(std::move(tooth)),
          bur_(std::move(bur)),
          request_(allContacts ? std::numeric_limits<int>::max() : 1, allContacts) {}

    [[nodiscard]] std::string name() const override { return name_; }
    [[nodiscard]] std::string gives() const override { return gives_; }

    bool tick(const Pose& deviceInTooth) override {
        fcl::Transform3d pose = fcl::Transform3d::Identity();
        pose.linear() = deviceInTooth.rotation.toRotationMatrix();
        pose.translation() = deviceInTooth.position;
        fcl::CollisionResultd result;
        fcl::collide(tooth_.get(), fcl::Transform3d::Identity(), bur_.get(), pose, request_, result);
        return result.isCollision();
    }

private:
    std::string name_, gives_;
    std::shared_ptr<const fcl::CollisionGeometryd> tooth_, bur_;
    fcl::CollisionRequestd request_;
};

}  // namespace

void addFclPeers(const Pair& pair, Peers& peers) {
    const auto tooth = modelOf(pair.tooth);
    const auto bur = modelOf(pair.bur);
    const auto hull = convexOf(pair.burHull);
    peers.push_back(std::make_unique<FclBaseline>("FCL mesh-mesh OBBRSS, yes or no", "no depth", tooth, bur, false));
    peers.push_back(std::make_unique<FclBaseline>("FCL mesh-mesh OBBRSS, all contacts", "a guess", tooth, bur, true));
    peers.push_back(std::make_unique<FclBaseline>("FCL convex bur (libccd), all", "per triangle", tooth, hull, true));
}

}  // namespace tactooth::bench
