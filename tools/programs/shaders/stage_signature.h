// The signature of an entry point: its inputs and outputs by their HLSL semantics, which SPIR-V does not
// keep.
//
// Based on "Signatures", https://learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-signatures.
#pragma once

#include <string>
#include <vector>

namespace penumbra::shaders {

// `other` is bool, and types that stages do not exchange.
enum class SignatureType { floating, signed_integer, unsigned_integer, other };

struct SignatureElement {
  std::string semantic;  // in capitals, with its number: "TEXCOORD0"; "SV_POSITION" and others without one
  bool output = false;
  bool per_patch = false;  // for a hull or domain program: not of a control point
  int location = -1;       // the location in SPIR-V; -1 for a built-in value
  SignatureType type = SignatureType::other;
  int components = 0;       // components of one semantic, 1 to 4; 0 if unknown
  int count = 1;            // consecutive semantics: elements of an array, vectors of a matrix
  bool read = false;        // for inputs: an instruction of the optimised program reads it
  bool of_cascade = false;  // for outputs, of linted units: see lint/interpolated_cascade.h
  std::string written;      // the semantic as written in the source
  std::string file;         // the file that has the semantic; line 0 if unknown
  int line = 0;

  bool operator==(const SignatureElement&) const = default;
};

using Signature = std::vector<SignatureElement>;

}  // namespace penumbra::shaders
