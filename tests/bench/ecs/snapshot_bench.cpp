#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include "ecs/checksum.h"
#include "ecs/snapshot.h"

namespace rambla::ecs {
namespace {

struct Place {
    float x = 1.0f, y = 2.0f, z = 3.0f;
};
struct Speed {
    float x = 4.0f, y = 5.0f, z = 6.0f;
};

}  // namespace

template <>
struct reflection<Place> {
    static constexpr auto value =
        describe<Place>("place").field("x", &Place::x).field("y", &Place::y).field("z", &Place::z);
};
template <>
struct reflection<Speed> {
    static constexpr auto value =
        describe<Speed>("speed").field("x", &Speed::x).field("y", &Speed::y).field("z", &Speed::z);
};

namespace {

void sizes(benchmark::internal::Benchmark* benchmark) {
    benchmark->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMicrosecond);
}

/// Raw arrays of trivial values, not cleared first.
template <class T>
std::unique_ptr<T[]> array_of(std::size_t count) {
    return std::unique_ptr<T[]>{static_cast<T*>(::operator new[](count * sizeof(T)))};
}

/// The columns of a world of this size, and room for their bytes.
struct BareColumns {
    explicit BareColumns(std::size_t count) : entities(count), places(count), speeds(count) {}

    [[nodiscard]] std::size_t bytes() const {
        return entities.size() * (sizeof(Entity) + sizeof(Place) + sizeof(Speed));
    }

    std::vector<Entity> entities;
    std::vector<Place> places;
    std::vector<Speed> speeds;
};

template <class T>
std::byte* put(std::byte* to, const std::vector<T>& column) {
    std::memcpy(to, column.data(), column.size() * sizeof(T));
    return to + column.size() * sizeof(T);
}

void write_bare(benchmark::State& state) {
    const BareColumns columns{static_cast<std::size_t>(state.range(0))};
    std::vector<std::byte> stream(columns.bytes());
    for (auto _ : state) {
        put(put(put(stream.data(), columns.entities), columns.places), columns.speeds);
        benchmark::DoNotOptimize(checksum(stream));
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

template <class T>
const std::byte* get(const std::byte* from, std::size_t count, std::unique_ptr<T[]>& column) {
    column = array_of<T>(count);
    std::memcpy(static_cast<void*>(column.get()), from, count * sizeof(T));
    return from + count * sizeof(T);
}

void read_bare(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0));
    const std::vector<std::byte> stream(BareColumns{count}.bytes());
    for (auto _ : state) {
        std::unique_ptr<Entity[]> entities;
        std::unique_ptr<Place[]> places;
        std::unique_ptr<Speed[]> speeds;
        benchmark::DoNotOptimize(checksum(stream));
        get(get(get(stream.data(), count, entities), count, places), count, speeds);
        benchmark::DoNotOptimize(speeds.get());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

TypeRegistry registry() {
    TypeRegistry types;
    types.add<Place>();
    types.add<Speed>();
    return types;
}

void fill(World& world, std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i)
        world.create(Place{}, Speed{});
}

void write_rambla(benchmark::State& state) {
    World world;
    fill(world, state.range(0));
    const TypeRegistry types = registry();
    SnapshotWriter writer{types};
    for (auto _ : state)
        benchmark::DoNotOptimize(writer.write(world).data());
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

void read_rambla(benchmark::State& state) {
    World world;
    fill(world, state.range(0));
    const TypeRegistry types = registry();
    SnapshotWriter writer{types};
    const std::span<const std::byte> stream = writer.write(world);
    for (auto _ : state)
        benchmark::DoNotOptimize(read_snapshot(stream, types).world.get());
    state.SetItemsProcessed(state.iterations() * state.range(0));
}

BENCHMARK(write_bare)->Name("snapshot_write/bare")->Apply(sizes);
BENCHMARK(write_rambla)->Name("snapshot_write/rambla")->Apply(sizes);
BENCHMARK(read_bare)->Name("snapshot_read/bare")->Apply(sizes);
BENCHMARK(read_rambla)->Name("snapshot_read/rambla")->Apply(sizes);

}  // namespace
}  // namespace rambla::ecs
