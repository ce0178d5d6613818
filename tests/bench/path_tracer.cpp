// SPDX-License-Identifier: Apache-2.0
// How near the path tracer comes to its limit: the rays of a render, traced by the render itself
// and replayed through bare Embree. replay time / render time is the share of the render that no
// kernel could do without.
#include <benchmark/benchmark.h>
#include <embree3/rtcore.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <memory>
#include <vector>

#include "pathtracer/passes.h"
#include "scenes/scene_files.h"

namespace plumbline::pathtracer {
namespace {

constexpr int width = 240;
constexpr int height = 135;
constexpr int spp = Sampler::batch_size;

/// A ray that a render asked for, and how.
struct Query {
    enum class Kind { Camera, Bounce, Shadow };
    Ray ray;
    Kind kind;
};

/// Answers like the RayTracer it stands for, and keeps what it was asked.
class RecordingTracer {
 public:
    RecordingTracer(const RayTracer& tracer, std::vector<Query>& queries)
        : tracer_(tracer), queries_(queries) {}
    std::optional<Hit> intersect(const Ray& ray, BackFaces back_faces) const {
        const bool camera = back_faces == BackFaces::Cull;
        queries_.push_back({ray, camera ? Query::Kind::Camera : Query::Kind::Bounce});
        return tracer_.intersect(ray, back_faces);
    }
    bool occluded(const glm::vec3& a, const glm::vec3& b) const {
        queries_.push_back({{a, b - a, 1.f}, Query::Kind::Shadow});
        return tracer_.occluded(a, b);
    }
    const World& world() const { return tracer_.world(); }

 private:
    const RayTracer& tracer_;
    std::vector<Query>& queries_;
};

/// A scene ready to render, and the rays that rendering it takes.
struct Workload {
    World world;
    Effects effects;
    RayTracer tracer;
    std::vector<Query> queries;

    Workload(Scene scene, int frame)
        : world(world_at(sized(scene), frame)), effects(effects_of(scene)), tracer(world) {
        const CameraRays camera_rays(world.camera);
        const RecordingTracer recorder(tracer, queries);
        for (int i = 0; i < width * height * spp; ++i) {
            const int x = i / spp % width;
            const int y = i / spp / width;
            Sampler sampler(pixel_key(0, x, y), i % spp);
            const glm::vec2 at = glm::vec2(x, y) + sampler.next_2d();
            constexpr Effects F = Effects{} | Effect::PointLights;
            trace_path<F>(recorder, camera_rays.through(at.x, at.y), sampler, PathOptions{});
        }
    }

 private:
    static const Scene& sized(Scene& scene) {
        scene.camera.width = width;
        scene.camera.height = height;
        return scene;
    }
};

const Workload& workload(std::int64_t index) {
    static const Workload cornell_box(load_scene("cornell-box"), 0);
    static const Workload room_with_door(load_scene("room-with-door"), 350);
    return index == 0 ? cornell_box : room_with_door;
}

/// The triangles of a world in Embree, with nothing else around them.
class BareEmbree {
 public:
    explicit BareEmbree(const World& world) {
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        for (const WorldMesh& mesh : world.meshes) add(mesh);
        rtcCommitScene(scene_);
    }
    ~BareEmbree() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    BareEmbree(const BareEmbree&) = delete;
    BareEmbree& operator=(const BareEmbree&) = delete;

    /// A value that depends on the answer.
    float trace(const Query& query) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit r;
        const auto& [origin, direction, t_max] = query.ray;
        r.ray = {origin.x,    origin.y, origin.z, 0.f, direction.x, direction.y,
                 direction.z, 0.f,      t_max,    ~0u, 0u,          0u};
        r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        if (query.kind == Query::Kind::Shadow) {
            rtcOccluded1(scene_, &context, &r.ray);
        } else {
            rtcIntersect1(scene_, &context, &r);
        }
        return r.ray.tfar;
    }

 private:
    void add(const WorldMesh& mesh) {
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        void* positions =
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    sizeof(glm::vec3), mesh.positions.size());
        void* triangles =
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    sizeof(glm::uvec3), mesh.triangles.size());
        std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<glm::vec3*>(positions));
        std::copy(mesh.triangles.begin(), mesh.triangles.end(),
                  static_cast<glm::uvec3*>(triangles));
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
    }

    RTCDevice device_ = rtcNewDevice(nullptr);
    RTCScene scene_ = rtcNewScene(device_);
};

void count_rays(benchmark::State& state, std::size_t rays_an_iteration) {
    state.counters["rays/s"] = benchmark::Counter(
        double(state.iterations()) * double(rays_an_iteration), benchmark::Counter::kIsRate);
}

void render(benchmark::State& state) {
    const Workload& work = workload(state.range(0));
    Progress::silence();
    std::uint64_t rays = 0;
    for (auto _ : state) {
        Passes passes(work.tracer, work.effects, {}, 0);
        Progress progress("benchmark", passes.tiles());
        passes.add({0, spp, spp}, progress);
        rays = passes.rays();
    }
    count_rays(state, rays);
}

void replay(benchmark::State& state) {
    const Workload& work = workload(state.range(0));
    const BareEmbree embree(work.world);
    for (auto _ : state) {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, work.queries.size()),
                          [&](const auto& range) {
                              float sum = 0.f;
                              for (std::size_t i = range.begin(); i != range.end(); ++i) {
                                  sum += embree.trace(work.queries[i]);
                              }
                              benchmark::DoNotOptimize(sum);
                          });
    }
    count_rays(state, work.queries.size());
}

// 0: cornell-box; 1: room-with-door at frame 350.
BENCHMARK(render)->Arg(0)->Arg(1)->UseRealTime()->MeasureProcessCPUTime()->Unit(
    benchmark::kMillisecond);
BENCHMARK(replay)->Arg(0)->Arg(1)->UseRealTime()->MeasureProcessCPUTime()->Unit(
    benchmark::kMillisecond);

}  // namespace
}  // namespace plumbline::pathtracer
