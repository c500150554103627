#include "shaderlab/parse.h"

#include <gtest/gtest.h>

TEST(Shader, Parses) {}
