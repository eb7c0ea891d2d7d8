// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// How long a picture takes: `view_bench [TOOTH.stl]` prints one CSV row a case, milliseconds a picture at 1280 x 800.
// "bare" is the least that OpenGL could do with the same triangles (one colour, no light, back faces skipped).
#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>

#include "geometry/io/stl_reader.h"
#include "support/shapes.h"
#include "view/camera/orbit_camera.h"
#include "view/gl/drawable.h"
#include "view/gl/egl_context.h"
#include "view/gl/render_target.h"
#include "view/gl/shader_program.h"
#include "view/gl/triangle_buffers.h"
#include "view/render/renderer.h"

namespace tactooth {
namespace {

constexpr ImageSize kSize{1280, 800};
constexpr int kPictures = 25;

/// A ball with the wrinkles of a molar's size, for machines without a scanned tooth.
TriangleMesh wrinkledBall(int sectors, int rings) {
    TriangleMesh mesh = test::sphere(Vec3::Zero(), 6, sectors, rings);
    for (Vec3f& vertex : mesh.vertices) {
        vertex *= 1 + 0.04F * std::sin(2 * vertex.x()) * std::sin(2.3F * vertex.y()) * std::cos(1.7F * vertex.z());
    }
    return mesh;
}

/// A turn of the camera by one degree a picture, as when a student looks around.
Camera cameraAt(const Box3& box, int picture) {
    OrbitCamera camera;
    camera.fit(box, kSize.aspect());
    camera.setView({std::numbers::pi / 180 * picture, 0.6});
    return camera.camera();
}

void report(const char* name, std::size_t triangles, const std::function<void(int)>& draw) {
    std::vector<double> times;
    for (int picture = 0; picture < kPictures + 3; ++picture) {
        const auto begin = std::chrono::steady_clock::now();
        draw(picture);
        glFinish();
        const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
        if (picture >= 3) times.push_back(taken.count());
    }
    std::sort(times.begin(), times.end());
    std::printf("%s,%zu,%.1f,%.1f,%.1f\n", name, triangles, times.front(), times[times.size() / 2], times.back());
    std::fflush(stdout);
}

/// One program, one draw call, nothing else.
class BareDraw {
public:
    explicit BareDraw(const TriangleMesh& mesh)
        : buffers_(static_cast<std::uint32_t>(mesh.vertices.size()), static_cast<std::uint32_t>(mesh.triangles.size())),
          triangles_(static_cast<std::uint32_t>(mesh.triangles.size())) {
        std::vector<ShadingVertex> vertices;
        for (const Vec3f& v : mesh.vertices) vertices.push_back({{v.x(), v.y(), v.z()}, 0, 0});
        buffers_.writeVertices(0, vertices);
        buffers_.writeTriangles(0, mesh.triangles);
        auto program = ShaderProgram::create(
            "bare", "",
            {"layout(location = 0) in vec3 p; uniform mat4 m; void main() { gl_Position = m * vec4(p, 1.0); }"},
            {"layout(location = 0) out vec4 c; void main() { c = vec4(0.8); }"});
        program_ = std::move(program.value());
    }
    void draw(const RenderTarget& target, const Camera& camera) {
        target.bindForDrawing();
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_CULL_FACE);
        program_.use();
        program_.set("m", Mat4(projectionMatrix(camera, kSize.aspect()) * viewMatrix(camera)));
        const TriangleRange all{0, triangles_};
        buffers_.draw({&all, 1});
    }

private:
    TriangleBuffers buffers_;
    std::uint32_t triangles_;
    ShaderProgram program_;
};

Scene sceneOf(const std::shared_ptr<const TriangleMesh>& mesh) {
    Scene scene;
    SceneObject tooth;
    tooth.shape = mesh;
    tooth.appearances = {appearances::enamel()};
    scene.objects = {tooth};
    return scene;
}

void measure(Renderer& renderer, const std::string& name, const std::shared_ptr<const TriangleMesh>& mesh) {
    const auto target = RenderTarget::create(kSize, 0);
    if (!target) return;
    const Box3 box = boundingBox(*mesh);
    BareDraw bare(*mesh);
    const std::size_t triangles = mesh->triangles.size();
    report((name + " bare").c_str(), triangles, [&](int i) { bare.draw(*target, cameraAt(box, i)); });
    Scene scene = sceneOf(mesh);
    const auto draw = [&](const RenderSettings& settings, bool lightFollows) {
        return [&, settings, lightFollows](int i) {
            scene.camera = cameraAt(box, i);
            if (lightFollows) scene.lighting = operatingLight(scene.camera);
            if (const auto done = renderer.render(scene, target->framebuffer(), kSize, settings); !done) {
                std::fprintf(stderr, "%s\n", done.error().message().c_str());
            }
        };
    };
    report((name + " without shadow").c_str(), triangles, draw({.shadows = Shadows::None}, false));
    report((name + " quick").c_str(), triangles, draw(kQuick, false));
    report((name + " quick, light follows").c_str(), triangles, draw(kQuick, true));
    report((name + " fine").c_str(), triangles, draw(kFine, false));
    SceneMirror mirror;
    mirror.mirrorInWorld.position = box.center() + Vec3(0, 0, -0.6 * box.diagonal().norm());
    scene.mirror = mirror;
    report((name + " quick, mirror").c_str(), triangles, draw(kQuick, false));
}

int run(int count, char** arguments) {
    const auto context = EglContext::create();
    if (!context) return std::fprintf(stderr, "%s\n", context.error().message().c_str()), 1;
    auto renderer = Renderer::create();
    if (!renderer) return std::fprintf(stderr, "%s\n", renderer.error().message().c_str()), 1;
    std::printf("# %s\ncase,triangles,best_ms,median_ms,worst_ms\n",
                reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    measure(*renderer, "ball 20k", std::make_shared<const TriangleMesh>(wrinkledBall(144, 72)));
    measure(*renderer, "ball 325k", std::make_shared<const TriangleMesh>(wrinkledBall(570, 286)));
    if (count < 2) return 0;
    auto tooth = readStl(arguments[1]);
    if (!tooth) return std::fprintf(stderr, "%s\n", tooth.error().message().c_str()), 2;
    measure(*renderer, "tooth", std::make_shared<const TriangleMesh>(std::move(*tooth)));
    return 0;
}

}  // namespace
}  // namespace tactooth

int main(int count, char** arguments) { return tactooth::run(count, arguments); }
