#!/usr/bin/env python3
"""Makes the seed corpus of every fuzz target, and its dictionary, from the tests and the library's own files.

    tests/fuzz/seeds.py FOLDER FUZZ_SEEDS     writes FOLDER/TARGET/* and FOLDER/TARGET.dictionary

Texts that stand in the tests as raw strings are seeds as they are. FUZZ_SEEDS is the program of seeds_main.cpp, whose
messages of workers and reports are the program's own.
"""

import collections
import hashlib
import json
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import zlib

root = pathlib.Path(__file__).resolve().parents[2]
tests = root / 'tests'
sys.path.insert(0, str(root / 'tools' / 'pages'))
from results_table import read_table  # noqa: E402

LONGEST = 16384


def files(*patterns, folder=root):
    for pattern in patterns:
        for file in sorted(folder.glob(pattern)):
            if file.is_file():
                yield file.read_bytes()


def sources(patterns):
    return (text.decode() for text in files(*patterns, folder=tests))


def raw_strings(*patterns):
    """The raw strings of C++ sources, and what stands between quotes on a line of its own."""
    for source in sources(patterns):
        for match in re.finditer(r'R"([^()\\\s]{0,16})\((.*?)\)\1"', source, re.DOTALL):
            yield match[2].encode()


def quoted(*patterns):
    for source in sources(patterns):
        for match in re.finditer(r'"((?:[^"\\\n]|\\.)+)"', source):
            yield match[1].encode().decode('unicode_escape').encode('latin-1', 'replace')


def literals(*patterns):
    """The texts of C++ sources, each joined from the literals that stand side by side."""
    for source in sources(patterns):
        for match in re.finditer(r'(?:"(?:[^"\\\n]|\\.)*"\s*)+', re.sub(r'(?m)^#include.*$', '', source)):
            pieces = re.findall(r'"((?:[^"\\\n]|\\.)*)"', match[0])
            yield ''.join(pieces).encode().decode('unicode_escape').encode('latin-1', 'replace')


def first_bytes(first, contents):
    for content in contents:
        yield bytes([first]) + content


def cut(text, lists):
    """A JSON document whose long lists keep two elements."""
    document = json.loads(text)
    for name in lists:
        document[name] = document[name][:2]
    return json.dumps(document, indent=1).encode()


def results():
    """Each study's as a table and as JSON, of few frames and records."""
    for file in sorted(root.glob('Documentation~/results/*/results.tsv')):
        text = file.read_text()
        lines = text.splitlines(keepends=True)
        head = sum(line.startswith('#') for line in lines)
        yield ''.join(lines[:head + 3]).encode()
        yield cut(json.dumps(read_table(text)), ['frames', 'records'])
    yield cut((root / 'Documentation~/results/cost.json').read_text(), ['families', 'rows'])


def pictures():
    """Pictures of two by two pixels, in forms that are written in a few lines; and a PNG without a byte of pixels."""
    def png(colour, pixels):
        chunks = ((b'IHDR', struct.pack('>IIBBBBB', 2, 2, 8, colour, 0, 0, 0)), (b'IDAT', pixels), (b'IEND', b''))
        return b'\x89PNG\r\n\x1a\n' + b''.join(
            struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data)) for kind, data in chunks)

    for colour, channels in ((0, 1), (2, 3), (4, 2), (6, 4)):
        yield png(colour, zlib.compress(b''.join(b'\0' + bytes(range(2 * channels)) for _ in range(2))))
    yield png(6, b'')
    yield b'BM' + struct.pack('<IHHIIiiHHIIiiII', 70, 0, 0, 54, 40, 2, 2, 1, 24, 0, 16, 0, 0, 0, 0) + bytes(16)
    for kind in (2, 10):
        yield struct.pack('<BBBHHBHHHHBB', 0, 0, kind, 0, 0, 0, 0, 0, 2, 2, 24, 0) + bytes(range(16))


def models():
    """A square as two triangles of an STL file, and as numbers of vertices and faces."""
    corners = [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)]
    triangles = [(corners[0], corners[1], corners[2]), (corners[0], corners[2], corners[3])]
    yield b'\x04' + b''.join(
        struct.pack('<12fH', 0, 1, 0, *(x for corner in triangle for x in corner), 0) for triangle in triangles)
    vertices = b''.join(struct.pack('<9f', *corner, 0, 1, 0, corner[0], corner[2], 0) for corner in corners + corners)
    yield b'\x05' + vertices + bytes([0, 1, 2, 0, 0, 0, 2, 3, 0, 1]) + bytes([0, 1, 2, 3, 64])


def bakes():
    """A height field, with the hash (platform/content_hash.h) of the picture that the target writes."""
    picture = b'picture'
    hashed = hashlib.blake2b(len(picture).to_bytes(8, 'little') + picture, digest_size=32).hexdigest()
    yield json.dumps({
        'kind': 'height-field', 'version': 1, 'picture': 'field.png', 'heights_metres': [0, 12.5],
        'corner_metres': [-50, -25], 'size_metres': [100, 50], 'samples_without_surface': 0,
        'picture_hashes': {'field.png': hashed}}, indent=2).encode()


def technique_list():
    """The library's manifests, shortened, and those of the tests and studies; what they name is the target's own."""
    texts = [*raw_strings('techniques/caster_graph_test.cpp', 'techniques/pass_graph_test.cpp',
                          'techniques/technique_list_test.cpp'),
             *(file.read_bytes() for file in sorted([
                 *tests.glob('techniques/added/*.technique.json'), *tests.glob('study/**/*.technique.json')]))]
    for name in ('ShaderLibrary/Filters/Fixed/FixedPcf', 'ShaderLibrary/Filters/Pcss/PcssAngular', 'Shaders/PenumbraShadows'):
        document = json.loads((root / f'{name}.technique.json').read_text())
        for key, longest in (('techniques', 2), ('graphs', 3), ('looks', 1)):
            document[key] = document.get(key, [])[:longest]
        texts.append(json.dumps(document, indent=1).encode())
    for text in texts:
        for ending in (b'hlsl', b'shader', b'compute'):
            text = re.sub(rb'"[^"]*[.]' + ending + b'"', b'"a.' + ending + b'"', text)
        text = re.sub(rb'"library": "[^"]*"', b'"library": "."', text)
        yield re.sub(rb'"like": "[^"]*"', b'"like": "box"', text)


SHADERS = ['tests/cli/seeds/*', 'tests/validation/broken/**/*.hlsl', 'tests/*/refused/**/*.hlsl', 'tests/*/taken/*.hlsl',
           'tests/lint/*/*.hlsl', 'ShaderLibrary/**/*.hlsl']
ERRORS = ['unknown variable', 'no matching overloaded function found', 'Expected', 'array index out of range',
          'Entry point not found']
HLSL = ['preparation/*_test.cpp', 'hlsl/*_test.cpp', 'lint/*_test.cpp', 'shaders/*_test.cpp']


def in_function(text):
    cases = re.match(rb'(case|default)\b', text)
    body = b'float v = 0; switch (n) {\n' + text + b'\n}' if cases else text
    return b'int n;\nfloat4 Frag(float4 p : SV_Position) : SV_Target {\n' + body + b'\nreturn 1; }\n'


def lines(*patterns):
    return [line.strip() for text in files(*patterns) for line in text.splitlines() if not line.startswith(b'//')]


def statements(texts):
    """Pieces of HLSL: as they are, and those that declare no function as the body of an entry point."""
    pieces = [text for text in texts if re.search(rb'[;{}]', text)]
    return pieces + [in_function(text) for text in pieces if not re.match(rb'\w+ \w+\(', text)]


def logged(texts):
    """The texts behind lines of a compiler's log about them."""
    for number, text in enumerate(texts):
        yield f"ERROR: main.hlsl:{2 + number % 9}: 'one' : {ERRORS[number % len(ERRORS)]} \n".encode() + text


def in_shaders(texts):
    """The texts as they are, as the commands of a pass, and as the tags of a sub-shader."""
    for text in texts:
        yield text
        if b'Shader' not in text:
            yield b'Shader "x" { SubShader { Pass {\n' + text + b'\n} } }'
            yield b'Shader "x" { SubShader { Tags {\n' + text + b'\n} Pass { } } }'


def target_seeds():
    shader_texts = list(files(*SHADERS))
    hlsl_texts = list(raw_strings(*HLSL)) + shader_texts
    checked = statements([*literals('preparation/source_checks_test.cpp'),
                          *lines('tests/preparation/refused/*.hlsl', 'tests/preparation/taken/*.hlsl')])
    shaderlab = list(raw_strings('shaderlab/*', 'variants/*', 'validation/*.cpp')) + list(
        files('tests/**/*.shader', 'tests/**/*.compute', 'Shaders/*.shader', 'Samples~/**/*.shader'))
    json_texts = list(raw_strings('parameters/*_input_test.cpp', 'input/*.cpp', 'cli/*_test.cpp'))
    yield 'bake', bakes()
    yield 'cache_entries', [b'penumbra validation 1\n0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdefanswer', bytes(64)]
    yield 'expanded_text', [*hlsl_texts, *logged(files('tests/shaders/refused/unknown_names.hlsl'))]
    yield 'figures', results()
    yield 'messages', [*files('Documentation~/presets.md'), *quoted('input/visible_text_test.cpp')]
    yield 'model', models()
    yield 'option_values', [*quoted('variants/keyword_expression_test.cpp', 'project/*_test.cpp'),
                            *raw_strings('project/*_test.cpp')]
    yield 'bytecode', files('tests/shaders/bytecode/*.dxbc')
    yield 'picture', [*pictures(), *files('tests/golden/*.png')]
    yield 'pragmas', [*raw_strings('variants/*'), *quoted('variants/pragmas_test.cpp', 'variants/keyword_space_test.cpp')]
    yield 'preparation', [
        *first_bytes(0, hlsl_texts + statements(literals('preparation/*_test.cpp'))),
        *(bytes([entry]) + text for text in checked for entry in (*range(1, 7), 11))]
    macros = literals('preprocessing/preprocessor_test.cpp')
    yield 'preprocessing', [bytes([kind]) + text for text in [*macros, *shader_texts] for kind in range(2)]
    yield 'project_files', [
        *(bytes([kind]) + text for kind in range(4) for text in raw_strings('fuzz/project_files_fuzz.cpp')),
        *first_bytes(4, [b'm_EditorVersion: 2022.3.20f1\nm_EditorVersionWithRevision: 2022.3.20f1 (61c2feb0970d)\n']),
        *first_bytes(2, files('package.json'))]
    yield 'report', []
    yield 'settings', [*json_texts, *files('tests/golden/exported_shadow_state.json')]
    yield 'shaderlab', [*shaderlab, *in_shaders(literals('shaderlab/parse_test.cpp', 'shaderlab/broken_shaders_test.cpp'))]
    yield 'source_text', [*hlsl_texts, *raw_strings('variants/*')]
    yield 'stripping', [*raw_strings('variants/stripping_test.cpp', 'variants/urp_settings_test.cpp'),
                        *quoted('variants/build_settings_test.cpp', 'variants/used_variants_test.cpp'),
                        *files('tests/**/*.asset')]
    yield 'technique_list', technique_list()
    yield 'worker_messages', []


def dictionary(contents):
    """The words that most seeds hold, for libFuzzer to put where they do not belong. It refuses an empty file."""
    words = collections.Counter()
    for content in contents:
        words.update(set(re.findall(rb'[A-Za-z_#][A-Za-z0-9_]{2,40}', content)))
    chosen = sorted(word for word, _ in sorted(words.items(), key=lambda item: (-item[1], item[0]))[:400])
    return '# words of the seeds\n' + ''.join(f'"{word.decode()}"\n' for word in chosen)


def main(folder, program):
    chosen = dict(target_seeds())
    for target, seeds in chosen.items():
        place = folder / target
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir(parents=True)
        for content in {seed[:LONGEST] for seed in seeds if seed}:
            (place / hashlib.sha1(content).hexdigest()).write_bytes(content)
    subprocess.run([program, folder], check=True)
    for target in chosen:
        contents = [file.read_bytes() for file in (folder / target).iterdir()]
        (folder / f'{target}.dictionary').write_text(dictionary(contents))


main(pathlib.Path(sys.argv[1]), sys.argv[2])
