// The parser of the Debian package again, this time instrumented: its definitions come before those of the
// library.
#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
