#include "bench/assets/import_bench.h"

#include <benchmark/benchmark.h>
#include <tiny_gltf.h>

#include <stdexcept>
#include <string>

#include "assets/import/gltf_convert.h"

namespace rambla::bench {
namespace {

namespace gltf = assets::gltf;

bool leave_encoded(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int,
                   void*) {
    return true;
}

/// Pictures beside the document are left unread, as the importer leaves them.
bool is_no_picture(const std::string& file, void* user) {
    return file.ends_with(".bin") && tinygltf::FileExists(file, user);
}

tinygltf::Model parsed_by_tinygltf(const std::string& file) {
    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(leave_encoded, nullptr);
    parser.SetFsCallbacks({is_no_picture, tinygltf::ExpandFilePath, tinygltf::ReadWholeFile,
                           tinygltf::WriteWholeFile, nullptr});
    tinygltf::Model model;
    std::string error;
    std::string ignored;
    const bool parsed = file.ends_with(".glb") ? parser.LoadBinaryFromFile(&model, &error, &ignored, file)
                                               : parser.LoadASCIIFromFile(&model, &error, &ignored, file);
    if (!parsed) throw std::runtime_error{file + ": " + error};
    return model;
}

assets::Scene imported(const std::string& file) {
    gltf::Document document = gltf::load_document(file, {});
    assets::Scene scene;
    static_cast<void>(gltf::convert_data(document, scene));
    return scene;
}

struct Size {
    std::uint64_t bytes = 0;      ///< of the document and its buffers
    std::uint64_t triangles = 0;  ///< of all meshes, each once
};

Size size_of(const std::string& file) {
    gltf::Document document = gltf::load_document(file, {});
    assets::Scene scene;
    static_cast<void>(gltf::convert_data(document, scene));
    Size size{.bytes = std::filesystem::file_size(file), .triangles = 0};
    for (const tinygltf::Buffer& buffer : document.model.buffers)
        if (!buffer.uri.empty()) size.bytes += buffer.data.size();
    for (const assets::Mesh& mesh : scene.meshes)
        size.triangles += mesh.indices.size() / 3;
    return size;
}

template <class Read>
void measure(benchmark::State& state, const std::string& file, const Size& size, const Read& read) {
    for (auto _ : state)
        benchmark::DoNotOptimize(read(file));
    const auto iterations = static_cast<double>(state.iterations());
    const auto rate = benchmark::Counter::kIsRate;
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(size.bytes));
    state.counters["MB/s"] = {static_cast<double>(size.bytes) * 1e-6 * iterations, rate};
    state.counters["Mtriangles/s"] = {static_cast<double>(size.triangles) * 1e-6 * iterations, rate};
}

}  // namespace

void register_import_benchmarks(std::span<const Input> inputs) {
    for (const Input& input : inputs) {
        const std::string file = input.file.string();
        const Size size = size_of(file);
        const auto add = [&](const char* variant, auto read) {
            const std::string name =
                std::string{input.operation} + "/" + variant + "/" + std::to_string(size.triangles);
            benchmark::RegisterBenchmark(name.c_str(),
                                         [=](benchmark::State& state) { measure(state, file, size, read); });
        };
        add("bare", parsed_by_tinygltf);
        add("rambla", imported);
    }
}

}  // namespace rambla::bench
