#pragma once

#include <cstddef>
#include <tuple>

#include "ecs/filters.h"
#include "ecs/query.h"
#include "property/ecs/model.h"

namespace rambla::ecs::property {

/// What a query term means, said about a model's entity.
template <class T>
struct TermModel {
    using Part = std::remove_const_t<T>;
    static bool fits(const ModelEntity& entity) { return entity.has(part_number<Part>()); }
    static void check(const ModelEntity& entity, const Part& part) {
        expect(read_part(part) == entity.parts[part_number<Part>()], "a query hands out a wrong value");
    }
};
template <>
struct TermModel<Entity> {
    static bool fits(const ModelEntity&) { return true; }
    static void check(const ModelEntity&, Entity) {}
};
template <class T>
struct TermModel<Optional<T>> {
    using Part = std::remove_const_t<T>;
    static bool fits(const ModelEntity&) { return true; }
    static void check(const ModelEntity& entity, const Part* part) {
        expect((part != nullptr) == entity.has(part_number<Part>()), "an optional part comes and goes");
        if (part != nullptr) TermModel<T>::check(entity, *part);
    }
};
template <class C>
struct TermModel<Shared<C>> : TermModel<const C> {};
template <class C>
struct TermModel<With<C>> {
    static bool fits(const ModelEntity& entity) { return entity.has(part_number<C>()); }
};
template <class C>
struct TermModel<Without<C>> {
    static bool fits(const ModelEntity& entity) { return !entity.has(part_number<C>()); }
};

template <class... Cs>
struct TermModel<AnyOf<Cs...>> {
    static bool fits(const ModelEntity& entity) { return (entity.has(part_number<Cs>()) || ...); }
};
template <class C>
struct TermModel<Enabled<C>> {
    static bool fits(const ModelEntity& entity) {
        return entity.has(part_number<C>()) && !entity.disabled[part_number<C>()];
    }
};
template <class C>
struct TermModel<Disabled<C>> {
    static bool fits(const ModelEntity& entity) {
        return entity.has(part_number<C>()) && entity.disabled[part_number<C>()];
    }
};

template <class ChunkType>
struct HandedOutCheck;
template <template <class...> class ChunkType, class... Terms>
struct HandedOutCheck<ChunkType<Terms...>> {
    template <class... Arguments>
    static void check(const ModelEntity& entity, Arguments&&... arguments) {
        (TermModel<Terms>::check(entity, arguments), ...);
    }
};

/// Walks over models, of all queries together.
inline std::uint32_t walks = 0;

/// A query of terms that only read, beside its meaning. Its first term is Entity.
template <class... Terms>
class CheckedQuery {
public:
    /// Every entity that fits comes once, with its values; nothing else comes.
    void check(const World& world, Model& model) {
        std::size_t fitting = 0;
        for (const auto& [key, entity] : model.entities())
            fitting += (TermModel<Terms>::fits(entity) && ...) ? 1u : 0u;
        expect(query_.count(world) == fitting, "a query counts wrongly");
        const std::uint32_t walk = ++walks;
        std::size_t seen = 0;
        query_.each(world, [&](Entity handle, const auto&... parts) {
            ModelEntity& entity = model.at(handle);
            expect((TermModel<Terms>::fits(entity) && ...), "a query hands out an entity that does not fit");
            expect(entity.visited != walk, "a query hands out an entity twice");
            entity.visited = walk;
            HandedOutCheck<typename Query<Terms...>::ChunkType>::check(entity, handle, parts...);
            ++seen;
        });
        expect(seen == fitting, "a query leaves out an entity");
        check_chunks(world, fitting);
    }

private:
    void check_chunks(const World& world, std::size_t fitting) {
        std::size_t rows = 0;
        for (const auto& chunk : query_.chunks(world)) {
            expect(chunk.size() >= 1 && chunk.size() <= k_chunk_rows, "a chunk has a wrong size");
            expect(chunk.template get<0>().size() == chunk.size(), "a span is shorter than its chunk");
            rows += chunk.rows().count();
        }
        expect(rows == fitting, "chunks and rows disagree");
    }

    Query<Terms...> query_;
};

}  // namespace rambla::ecs::property
