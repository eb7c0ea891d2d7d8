// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/detached_pieces.h"

#include <deque>
#include <optional>
#include <unordered_map>

#include "collision/bvh/closest_point.h"
#include "geometry/util/assert.h"
#include "geometry/util/disjoint_sets.h"
#include "tooth/model/leaf_cache.h"

// Own method: a flood fill (connected components). The connected solid nodes of a brick form one part. The fill also
// passes through bricks between them that were never sampled. Such a brick counts as solid throughout if the tooth's
// surface runs through it. So a piece may count as attached where nothing holds it, but no attached piece is ever
// dropped.

namespace tactooth {
namespace {

constexpr int kUnvisited = -1;
constexpr int kAir = -2;

/// Connected solid nodes of one brick.
struct Part {
    BrickKey key;
    NodeSet nodes;
    int piece = kUnvisited;
};

struct Piece {
    std::vector<std::size_t> parts;
    std::vector<BrickKey> unsampled;
    bool isLarge = false;  ///< too large: the search has stopped before its end

    [[nodiscard]] std::size_t size() const { return parts.size() + unsampled.size(); }
};

class ComponentSearch {
public:
    ComponentSearch(const BrickMap& bricks, const LayeredTooth& tooth, const Lattice& lattice)
        : bricks_(bricks), outer_(*tooth.outer()), lattice_(lattice) {
        for (const BrickKey& key : bricks.keys()) addParts(key);
    }

    [[nodiscard]] std::vector<Piece> run() {
        std::vector<Piece> pieces;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if (parts_[i].piece != kUnvisited) continue;
            number_ = static_cast<int>(pieces.size());
            piece_ = {};
            flood(i);
            pieces.push_back(std::move(piece_));
        }
        return pieces;
    }
    [[nodiscard]] const Part& part(std::size_t i) const { return parts_[i]; }

private:
    struct Range {
        std::size_t first, end;
    };

    void addParts(const BrickKey& key) {
        const std::size_t first = parts_.size();
        NodeSet left = solidNodes(*bricks_.find(key));
        while (left.any()) {
            parts_.push_back({key, firstComponent(left)});
            TACTOOTH_ASSERT(parts_.back().nodes.any());
            left &= ~parts_.back().nodes;
        }
        partsOf_[key] = {first, parts_.size()};
    }

    /// Parts come before unsampled bricks, so that a large piece has all its parts before the search stops.
    void flood(std::size_t first) {
        visitPart(first);
        while (!partsToDo_.empty() || !unsampledToDo_.empty()) {
            if (!partsToDo_.empty()) {
                const Part& part = parts_[partsToDo_.back()];
                partsToDo_.pop_back();
                for (const BrickFace& face : kBrickFaces) cross(part.key, face, part.nodes & face.nodes());
            } else if (piece_.unsampled.size() > kMaxUnsampled) {
                piece_.isLarge = true;
                unsampledToDo_.clear();
            } else {
                const BrickKey key = unsampledToDo_.front();
                unsampledToDo_.pop_front();
                for (const BrickFace& face : kBrickFaces) cross(key, face, face.nodes());
            }
        }
    }

    /// Continues from some nodes on a face of a brick to those beyond the face.
    void cross(const BrickKey& key, const BrickFace& face, const NodeSet& from) {
        TACTOOTH_ASSERT((from & ~face.nodes()).none());
        if (from.none()) return;
        const BrickKey beyond = face.beyond(key);
        if (!bricks_.knows(beyond)) return visitUnsampled(beyond);
        const auto found = partsOf_.find(beyond);
        if (found == partsOf_.end()) return;
        const NodeSet there = face.across(from);
        for (std::size_t i = found->second.first; i < found->second.end; ++i) {
            if ((parts_[i].nodes & there).any()) visitPart(i);
        }
    }

    void visitPart(std::size_t i) {
        TACTOOTH_ASSERT(i < parts_.size());
        if (!isUnvisited(parts_[i].piece)) return;
        parts_[i].piece = number_;
        piece_.parts.push_back(i);
        partsToDo_.push_back(i);
    }

    void visitUnsampled(const BrickKey& key) {
        int& piece = unsampled_.try_emplace(key, kUnvisited).first->second;
        if (piece == kUnvisited && !mayBeSolid(key)) piece = kAir;
        if (piece == kAir || !isUnvisited(piece)) return;
        piece = number_;
        piece_.unsampled.push_back(key);
        unsampledToDo_.push_back(key);
    }

    /// Whether no piece has reached this place. Another piece can have been here only if its search was stopped: all
    /// others are known completely.
    [[nodiscard]] bool isUnvisited(int piece) {
        piece_.isLarge = piece_.isLarge || (piece != kUnvisited && piece != number_);
        return piece == kUnvisited;
    }

    [[nodiscard]] bool mayBeSolid(const BrickKey& key) const {
        const Vec3 centre = lattice_.centre(key);
        if (!LeafCache(outer_, centre, lattice_.halfDiagonal() + lattice_.spacing()).empty()) return true;
        return outer_.tree().box().contains(centre) && contains(outer_, centre);
    }

    const BrickMap& bricks_;
    const SurfacePart& outer_;
    const Lattice& lattice_;
    std::vector<Part> parts_;
    std::unordered_map<BrickKey, Range, BrickKeyHash> partsOf_;
    std::unordered_map<BrickKey, int, BrickKeyHash> unsampled_;  // number of the piece
    std::vector<std::size_t> partsToDo_;
    std::deque<BrickKey> unsampledToDo_;
    Piece piece_;
    int number_ = 0;
};

/// The closed bodies of the tooth's outer surface.
class Bodies {
public:
    explicit Bodies(const SurfacePart& outer) : outer_(outer), vertices_(outer.mesh().vertices.size()) {
        for (const Triangle& triangle : outer.mesh().triangles) {
            vertices_.join(triangle[0], triangle[1]);
            vertices_.join(triangle[1], triangle[2]);
        }
    }

    /// The body whose surface is within `reach` (mm) of a point.
    [[nodiscard]] std::optional<std::uint32_t> near(const Vec3& point, double reach) {
        const auto closest = closestPoint(outer_, point, reach);
        if (!closest) return std::nullopt;
        return vertices_.find(outer_.mesh().triangles[closest->triangle][0]);
    }

private:
    const SurfacePart& outer_;
    DisjointSets vertices_;
};

/// The body of a piece. Nothing for a piece from the interior of a body, without any of its surface.
std::optional<std::uint32_t> bodyOf(const Piece& piece, const ComponentSearch& search, const BrickMap& bricks,
                                    const Lattice& lattice, Bodies& bodies) {
    const double reach = kToothBand * lattice.spacing();
    for (const std::size_t i : piece.parts) {
        const Part& part = search.part(i);
        const Brick& brick = *bricks.find(part.key);
        for (int node = 0; node < kBrickNodes; ++node) {
            if (!part.nodes[static_cast<std::size_t>(node)] || brick.tooth[node] <= -reach) continue;
            return bodies.near(lattice.node(part.key, placeOf(node)), reach);
        }
    }
    for (const BrickKey& key : piece.unsampled) {
        if (const auto body = bodies.near(lattice.centre(key), lattice.halfDiagonal() + lattice.spacing())) return body;
    }
    return std::nullopt;
}

}  // namespace

std::vector<DetachedPiece> findDetachedPieces(const BrickMap& bricks, const LayeredTooth& tooth,
                                              const Lattice& lattice) {
    ComponentSearch search(bricks, tooth, lattice);
    const std::vector<Piece> pieces = search.run();
    if (pieces.size() < 2) return {};

    Bodies bodies(*tooth.outer());
    std::vector<std::optional<std::uint32_t>> bodyOfPiece(pieces.size());
    std::map<std::uint32_t, std::size_t> largest;  // largest piece of each body
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        bodyOfPiece[i] = bodyOf(pieces[i], search, bricks, lattice, bodies);
        if (!bodyOfPiece[i]) continue;
        std::size_t& best = largest.try_emplace(*bodyOfPiece[i], i).first->second;
        const auto rank = [&](std::size_t p) { return std::pair(pieces[p].isLarge, pieces[p].size()); };
        if (rank(i) > rank(best)) best = i;
    }
    std::vector<DetachedPiece> detached;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (pieces[i].isLarge || (bodyOfPiece[i] && largest[*bodyOfPiece[i]] == i)) continue;
        DetachedPiece& piece = detached.emplace_back();
        piece.unsampled = pieces[i].unsampled;
        for (const std::size_t part : pieces[i].parts) piece.nodes[search.part(part).key] |= search.part(part).nodes;
        TACTOOTH_ASSERT(!piece.nodes.empty());
    }
    return detached;
}

}  // namespace tactooth
