#include "ecs/snapshot_parse.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <string>
#include <string_view>

#include "ecs/checksum.h"
#include "ecs/misuse.h"
#include "ecs/world_access.h"

namespace rambla::ecs::detail {
namespace {

std::string quoted(std::string_view text) {
    return '"' + std::string{text} + '"';
}

std::string to_text(const ChainPosition& position) {
    return "a delta after version " + std::to_string(position.version) + " with checksum " +
           std::to_string(position.checksum);
}

/// Turns a stream into a ParsedStream, part by part.
class Parser {
public:
    Parser(std::span<const std::byte> bytes, const World& world, const TypeRegistry& registry,
           bool drop_unknown_components, ParsedStream& parsed)
        : in_{bytes.first(bytes.size() - k_checksum_bytes), k_header_bytes},
          world_{world},
          graph_{WorldAccess::graph(world)},
          registry_{registry},
          drop_unknown_{drop_unknown_components},
          parsed_{parsed} {}

    void parse() {
        parse_components();
        parse_archetypes();
        const std::uint32_t count = in_.count(k_least_rows_bytes);
        for (std::uint32_t i = 0; i < count; ++i)
            parse_rows();
        const std::size_t sparse_at = in_.offset();
        parse_sparse();
        parse_slots();
        check_sparse(parsed_, world_, sparse_at);
        parse_resources();
        if (in_.left() != 0) fail(std::to_string(in_.left()) + " bytes more", "the end");
    }

private:
    static constexpr std::size_t k_least_component_bytes = 13;
    static constexpr std::size_t k_least_rows_bytes = 12;
    static constexpr std::size_t k_run_bytes = 8;
    static constexpr std::size_t k_least_sparse_bytes = 8;

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
        throw SnapshotError{in_.offset(), found, expected};
    }

    void parse_components() {
        const std::uint32_t count = in_.count(k_least_component_bytes);
        const std::size_t known = graph_.component_count();
        if (count < known || count >= k_no_component) {
            fail(std::to_string(count) + " components",
                 std::to_string(known) + " to " + std::to_string(k_no_component - 1));
        }
        for (std::uint32_t i = 0; i < count; ++i)
            parse_component(i < known ? &graph_.info(static_cast<ComponentId>(i)) : nullptr);
    }

    /// @param known  which one it must be, null for new ones
    void parse_component(const ComponentInfo* known) {
        const std::size_t at = in_.offset();
        const std::string_view name = in_.text();
        const auto flags = in_.number<std::uint8_t>();
        StoredSchema schema = read_schema(name, in_);
        const ComponentType* type = registry_.component(name);
        if (type == nullptr && !drop_unknown_) {
            throw SnapshotError{at, "component " + quoted(name), "one that the registry knows"};
        }
        if (type == nullptr) {
            parsed_.dropped.emplace_back(name);
        } else {
            check_component(*type, flags, known, at);
        }
        for (const ParsedStream::Component& other : parsed_.components) {
            if (type != nullptr && other.type == type)
                throw SnapshotError{at, "component " + quoted(name), "each component once"};
        }
        const bool has_values = (flags & (k_tag_flag | k_transient_flag)) == 0;
        const bool converts = has_values && type != nullptr;
        const TypeRegistry::Migration* migration = registry_.migration(name, schema.version);
        parsed_.components.push_back(
            {type, has_values, (flags & k_sparse_flag) != 0, (flags & k_shared_flag) != 0,
             RowDecoder{std::move(schema), converts ? type->description : nullptr, migration, at}});
    }

    static void check_component(const ComponentType& type, std::uint8_t flags, const ComponentInfo* known,
                                std::size_t at) {
        const std::uint8_t wanted = flags_of(type);
        if (flags != wanted) {
            throw SnapshotError{at, quoted(type.name) + " with flags " + std::to_string(flags),
                                "flags " + std::to_string(wanted)};
        }
        if (known != nullptr && known->type_index != type.info->type_index) {
            throw SnapshotError{at, "component " + quoted(type.name), "the world's " + quoted(known->name)};
        }
    }

    void parse_archetypes() {
        const auto known = in_.number<std::uint32_t>();
        if (known != graph_.size()) {
            fail(std::to_string(known) + " archetypes before", std::to_string(graph_.size()));
        }
        parsed_.known_archetypes = known;
        const std::uint32_t count = in_.count(sizeof(std::uint32_t));
        for (std::uint32_t i = 0; i < count; ++i) {
            std::vector<ComponentId> signature(in_.count(sizeof(ComponentId)));
            for (ComponentId& component : signature)
                component = in_.number<ComponentId>();
            const bool ascending = std::adjacent_find(signature.begin(), signature.end(),
                                                      std::greater_equal<>{}) == signature.end();
            if (!ascending || (!signature.empty() && signature.back() >= parsed_.components.size())) {
                fail("an archetype of doubled, unsorted or unknown components",
                     "ascending numbers below " + std::to_string(parsed_.components.size()));
            }
            check_signature(signature);
            ParsedStream::Archetype archetype{std::move(signature), {}};
            for (const ComponentId component : archetype.signature)
                parse_shared(parsed_.components[component], archetype);
            if (parsed_.dropped.empty() && is_known(archetype)) fail("the same archetype again", "each once");
            archetypes_with_[archetype.signature].push_back(i);
            parsed_.archetypes.push_back(std::move(archetype));
        }
    }

    void parse_shared(const ParsedStream::Component& component, ParsedStream::Archetype& archetype) {
        if (!component.shared || !component.has_values) return;
        const std::span<const std::byte> value = component.decoder.take_valid(in_, 1);
        if (component.type == nullptr) return;
        archetype.shared.emplace_back(*component.type, 1);
        component.decoder.decode(value, 1, archetype.shared.back().objects());
    }

    /// Whether the world or the stream has an archetype of these components and shared values.
    [[nodiscard]] bool is_known(const ParsedStream::Archetype& archetype) {
        const auto same = [&](const auto& value_of) {
            std::size_t i = 0;
            return std::all_of(archetype.shared.begin(), archetype.shared.end(),
                               [&](const StagedRows& value) {
                                   const std::byte* other = value_of(i++);
                                   const ComponentInfo& info = value.info();
                                   return info.equal(value.objects(), other) ||
                                          std::memcmp(value.objects(), other, info.size) == 0;
                               });
        };
        for (std::uint32_t i = 0; i < parsed_.known_archetypes; ++i) {
            const auto& shared = graph_[i].shared();
            if (std::ranges::equal(graph_[i].signature(), archetype.signature) &&
                same([&](std::size_t place) { return shared[place]->bytes; }))
                return true;
        }
        const std::vector<std::uint32_t>& others = archetypes_with_[archetype.signature];
        return std::any_of(others.begin(), others.end(), [&](std::uint32_t other) {
            const std::vector<StagedRows>& shared = parsed_.archetypes[other].shared;
            return same([&](std::size_t place) { return shared[place].objects(); });
        });
    }

    /// No sparse components, and EnableStates exactly where their components are.
    void check_signature(const std::vector<ComponentId>& signature) const {
        const auto has = [&](const auto& wanted) {
            return std::any_of(signature.begin(), signature.end(), [&](ComponentId component) {
                const ComponentType* type = parsed_.components[component].type;
                return type != nullptr && wanted(*type->info);
            });
        };
        for (const ComponentId component : signature) {
            if (parsed_.components[component].sparse) fail("a sparse component in an archetype", "none");
            const ComponentType* type = parsed_.components[component].type;
            if (type == nullptr) continue;
            const ComponentInfo& info = *type->info;
            const auto is_companion = [&](const ComponentInfo& other) {
                return &other == info.companion;
            };
            const auto is_owner = [&](const ComponentInfo& other) {
                return other.companion == &info;
            };
            if ((info.companion != nullptr && !has(is_companion)) || (info.is_companion && !has(is_owner)))
                fail(quoted(type->name) + " on its own", "a component and its enable bits together");
        }
    }

    void parse_rows() {
        ParsedStream::Rows rows{};
        rows.archetype = in_.number<std::uint32_t>();
        const std::uint32_t archetypes =
            parsed_.known_archetypes + static_cast<std::uint32_t>(parsed_.archetypes.size());
        const bool ascending = parsed_.rows.empty() || parsed_.rows.back().archetype < rows.archetype;
        if (rows.archetype >= archetypes || !ascending) {
            fail("archetype " + std::to_string(rows.archetype),
                 "ascending numbers below " + std::to_string(archetypes));
        }
        rows.rows = in_.number<std::uint32_t>();
        if (rows.rows > WorldAccess::max_rows(graph_)) {
            detail::throw_full("rows in one archetype", WorldAccess::max_rows(graph_));
        }
        const bool known = rows.archetype < parsed_.known_archetypes;
        const std::uint32_t old_rows = known ? graph_[rows.archetype].rows() : 0;
        rows.entities = parse_runs(rows.rows, old_rows);
        for (ParsedStream::Run& run : rows.entities)
            run.values = in_.take(std::uint64_t{run.rows} * sizeof(Entity));
        const std::span<const ComponentId> signature =
            known ? graph_[rows.archetype].signature()
                  : std::span<const ComponentId>{
                        parsed_.archetypes[rows.archetype - parsed_.known_archetypes].signature};
        for (const ComponentId component : signature) {
            const ParsedStream::Component& stored = parsed_.components[component];
            if (!stored.has_values || stored.shared) continue;
            ParsedStream::Column column{component, parse_runs(rows.rows, old_rows)};
            for (ParsedStream::Run& run : column.runs)
                run.values = stored.decoder.take_valid(in_, run.rows);
            rows.columns.push_back(std::move(column));
        }
        parsed_.rows.push_back(std::move(rows));
    }

    /// Runs ascend, do not overlap, stay below `rows`, and leave out none of the rows from `old_rows` on.
    std::vector<ParsedStream::Run> parse_runs(std::uint32_t rows, std::uint32_t old_rows) {
        std::vector<ParsedStream::Run> runs(in_.count(k_run_bytes));
        std::uint64_t end = 0;
        for (ParsedStream::Run& run : runs) {
            run.first = in_.number<std::uint32_t>();
            run.rows = in_.number<std::uint32_t>();
            const bool gap_in_new = run.first > end && run.first > old_rows;
            if (run.first < end || run.rows == 0 || gap_in_new) {
                fail("a run of " + std::to_string(run.rows) + " rows from " + std::to_string(run.first),
                     "ascending runs that leave out no new row");
            }
            end = std::uint64_t{run.first} + run.rows;
        }
        if (end > rows || (end < rows && rows > old_rows)) {
            fail("runs up to row " + std::to_string(end), "up to " + std::to_string(rows));
        }
        return runs;
    }

    void parse_sparse() {
        const std::uint32_t count = in_.count(k_least_sparse_bytes);
        for (std::uint32_t i = 0; i < count; ++i) {
            ParsedStream::Sparse set{};
            set.component = in_.number<std::uint32_t>();
            const bool ascending = parsed_.sparse.empty() || parsed_.sparse.back().component < set.component;
            if (!ascending || set.component >= parsed_.components.size() ||
                !parsed_.components[set.component].sparse) {
                fail("a sparse set of component " + std::to_string(set.component),
                     "ascending numbers of sparse components");
            }
            set.size = in_.count(sizeof(Entity));
            set.entities = in_.take(set.size * sizeof(Entity));
            const ParsedStream::Component& stored = parsed_.components[set.component];
            if (stored.has_values) set.values = stored.decoder.take_valid(in_, set.size);
            parsed_.sparse.push_back(set);
        }
    }

    void parse_slots() {
        const std::size_t at = in_.offset();
        parsed_.slots = in_.number<std::uint32_t>();
        parsed_.free_kept = in_.number<std::uint32_t>();
        parsed_.free.resize(in_.count(sizeof(Entity)));
        for (Entity& slot : parsed_.free) {
            slot.index = in_.number<std::uint32_t>();
            slot.generation = in_.number<std::uint32_t>();
        }
        parsed_.retired.resize(in_.count(sizeof(std::uint32_t)));
        for (std::uint32_t& slot : parsed_.retired)
            slot = in_.number<std::uint32_t>();
        check_slots(parsed_, world_, at);
    }

    void parse_resources() {
        const std::uint32_t count = in_.count(k_least_component_bytes);
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::size_t at = in_.offset();
            const std::string_view name = in_.text();
            StoredSchema schema = read_schema(name, in_);
            const ResourceType* type = registry_.resource(name);
            if (type == nullptr) {
                throw SnapshotError{at, "resource " + quoted(name), "one that the registry knows"};
            }
            for (const ParsedStream::Resource& other : parsed_.resources) {
                if (other.type == type)
                    throw SnapshotError{at, "resource " + quoted(name), "each resource once"};
            }
            const TypeRegistry::Migration* migration = registry_.migration(name, schema.version);
            RowDecoder decoder{std::move(schema), type->description, migration, at};
            const auto there = in_.number<std::uint8_t>();
            if (there > 1) fail(std::to_string(there), "0 or 1");
            if (there == 0) continue;
            const std::span<const std::byte> fields = decoder.take_valid(in_, 1);
            parsed_.resources.push_back({type, std::move(decoder), fields});
        }
    }

    ByteReader in_;
    const World& world_;
    const ArchetypeGraph& graph_;
    const TypeRegistry& registry_;
    bool drop_unknown_;
    ParsedStream& parsed_;
    std::map<std::vector<ComponentId>, std::vector<std::uint32_t>> archetypes_with_;  ///< new, by signature
};

}  // namespace

std::uint8_t flags_of(const ComponentType& type) {
    const ComponentInfo& info = *type.info;
    return static_cast<std::uint8_t>((info.size == 0 ? k_tag_flag : 0) |
                                     (type.transient() ? k_transient_flag : 0) |
                                     (info.storage == Storage::sparse ? k_sparse_flag : 0) |
                                     (info.storage == Storage::shared ? k_shared_flag : 0));
}

Entity entity_at(std::span<const std::byte> entities, std::uint32_t row) {
    Entity entity;
    copy_little_endian(reinterpret_cast<std::byte*>(&entity), entities.data() + row * sizeof(Entity),
                       sizeof(Entity), sizeof(std::uint32_t));
    return entity;
}

StreamHeader read_header(std::span<const std::byte> bytes, StreamKind kind) {
    if (bytes.size() < k_header_bytes + k_checksum_bytes) {
        throw SnapshotError{bytes.size(), std::to_string(bytes.size()) + " bytes",
                            "at least " + std::to_string(k_header_bytes + k_checksum_bytes)};
    }
    ByteReader in{bytes};
    if (std::memcmp(in.take(k_magic.size()).data(), k_magic.data(), k_magic.size()) != 0) {
        throw SnapshotError{0, "other bytes", "the beginning of a snapshot of ours"};
    }
    const auto format = in.number<std::uint32_t>();
    if (format != k_format) {
        throw SnapshotError{8, "format " + std::to_string(format), "format " + std::to_string(k_format)};
    }
    const auto found_kind = in.number<std::uint32_t>();
    if (found_kind != static_cast<std::uint32_t>(kind)) {
        const auto name = [](std::uint32_t number) -> std::string {
            return number == 1 ? "a snapshot" : number == 2 ? "a delta" : "kind " + std::to_string(number);
        };
        throw SnapshotError{12, name(found_kind), name(static_cast<std::uint32_t>(kind))};
    }
    const auto length = in.number<std::uint64_t>();
    if (length != bytes.size()) {
        throw SnapshotError{k_length_offset, std::to_string(bytes.size()) + " bytes", std::to_string(length)};
    }
    const std::size_t body = bytes.size() - k_checksum_bytes;
    const auto stored = ByteReader{bytes, body}.number<std::uint64_t>();
    const std::uint64_t computed = checksum(bytes.first(body));
    if (stored != computed) {
        throw SnapshotError{body, "checksum " + std::to_string(stored), std::to_string(computed)};
    }
    StreamHeader header{kind, {in.number<std::uint32_t>(), stored}, {}};
    header.base.version = in.number<std::uint32_t>();
    header.base.checksum = in.number<std::uint64_t>();
    return header;
}

void check_base(const StreamHeader& header, const ChainPosition& position) {
    if (header.base == position) return;
    throw SnapshotError{k_base_offset, to_text(header.base), to_text(position)};
}

ParsedStream parse_stream(std::span<const std::byte> bytes, const StreamHeader& header, const World& world,
                          const TypeRegistry& registry, bool drop_unknown_components) {
    ParsedStream parsed;
    parsed.header = header;
    Parser{bytes, world, registry, drop_unknown_components, parsed}.parse();
    return parsed;
}

}  // namespace rambla::ecs::detail
