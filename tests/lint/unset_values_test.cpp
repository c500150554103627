#include "lint/linted_shader.h"
namespace penumbra::lint { namespace {
TEST(A, B) {
  std::ifstream f("/tmp/h/lint-exp/a.hlsl");
}
}}
