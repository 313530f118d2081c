#include "fuzz/target.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace rambla::fuzz {

namespace {

std::vector<Target>& registered() {
    static std::vector<Target> k_targets;
    return k_targets;
}

}  // namespace

Registration::Registration(Target target) {
    registered().push_back(std::move(target));
}

std::vector<Target> targets() {
    std::vector<Target> all = registered();
    std::sort(all.begin(), all.end(), [](const Target& a, const Target& b) { return a.name < b.name; });
    return all;
}

void broken(std::string_view promise) {
    std::fprintf(stderr, "broken promise: %.*s\n", static_cast<int>(promise.size()), promise.data());
    std::abort();
}

}  // namespace rambla::fuzz
