#include "shaders/gl_check.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>
#include <mutex>

#include <cstdio>
#include <map>
#include <sstream>

#include "input/input_error.h"

namespace penumbra::shaders {

namespace {

EGLDisplay surfaceless_display() {
  static std::once_flag once;
  static EGLDisplay display = EGL_NO_DISPLAY;
  std::call_once(once, [] {
    EGLDisplay found = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (found != EGL_NO_DISPLAY && eglInitialize(found, nullptr, nullptr) == EGL_TRUE) display = found;
  });
  if (display == EGL_NO_DISPLAY)
    throw EnvironmentError(
        "EGL has no surfaceless display: install Mesa's EGL (Debian: libegl1, libegl-mesa0)");
  return display;
}

template <class Function>
Function gl_function(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

struct GlFunctions {
  PFNGLGETSTRINGPROC get_string = gl_function<PFNGLGETSTRINGPROC>("glGetString");
  PFNGLCREATESHADERPROC create_shader = gl_function<PFNGLCREATESHADERPROC>("glCreateShader");
  PFNGLSHADERSOURCEPROC shader_source = gl_function<PFNGLSHADERSOURCEPROC>("glShaderSource");
  PFNGLCOMPILESHADERPROC compile_shader = gl_function<PFNGLCOMPILESHADERPROC>("glCompileShader");
  PFNGLGETSHADERIVPROC get_shader = gl_function<PFNGLGETSHADERIVPROC>("glGetShaderiv");
  PFNGLGETSHADERINFOLOGPROC shader_log = gl_function<PFNGLGETSHADERINFOLOGPROC>("glGetShaderInfoLog");
  PFNGLDELETESHADERPROC delete_shader = gl_function<PFNGLDELETESHADERPROC>("glDeleteShader");
  PFNGLCREATEPROGRAMPROC create_program = gl_function<PFNGLCREATEPROGRAMPROC>("glCreateProgram");
  PFNGLPROGRAMPARAMETERIPROC program_parameter =
      gl_function<PFNGLPROGRAMPARAMETERIPROC>("glProgramParameteri");
  PFNGLATTACHSHADERPROC attach_shader = gl_function<PFNGLATTACHSHADERPROC>("glAttachShader");
  PFNGLLINKPROGRAMPROC link_program = gl_function<PFNGLLINKPROGRAMPROC>("glLinkProgram");
  PFNGLGETPROGRAMIVPROC get_program = gl_function<PFNGLGETPROGRAMIVPROC>("glGetProgramiv");
  PFNGLGETPROGRAMINFOLOGPROC program_log = gl_function<PFNGLGETPROGRAMINFOLOGPROC>("glGetProgramInfoLog");
  PFNGLDELETEPROGRAMPROC delete_program = gl_function<PFNGLDELETEPROGRAMPROC>("glDeleteProgram");
};

// The context of one dialect; it is made by the thread that uses it.
class Context {
 public:
  explicit Context(Target target)
      : display_(surfaceless_display()), es_(target_language(target) == TargetLanguage::essl) {
    const EGLint es_attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 1, EGL_NONE};
    const EGLint gl_attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                    4,
                                    EGL_CONTEXT_MINOR_VERSION,
                                    5,
                                    EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                    EGL_NONE};
    bind_api();
    context_ =
        eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, es_ ? es_attributes : gl_attributes);
    if (context_ == EGL_NO_CONTEXT || !make_current())
      throw EnvironmentError(std::string("EGL provides no ") + (es_ ? "OpenGL ES 3.1" : "OpenGL 4.5 core") +
                             " context, which checking " + target_name(target) + " needs");
  }
  ~Context() {
    bind_api();
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglReleaseThread();
  }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  bool make_current() {
    bind_api();
    return eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }

  const GlFunctions gl;

 private:
  void bind_api() const { eglBindAPI(es_ ? EGL_OPENGL_ES_API : EGL_OPENGL_API); }

  EGLDisplay display_;
  bool es_;
  EGLContext context_ = EGL_NO_CONTEXT;
};

GLenum stage_enum(hlsl::Stage stage) {
  switch (stage) {
    case hlsl::Stage::vertex:
      return GL_VERTEX_SHADER;
    case hlsl::Stage::hull:
      return GL_TESS_CONTROL_SHADER;
    case hlsl::Stage::domain:
      return GL_TESS_EVALUATION_SHADER;
    case hlsl::Stage::geometry:
      return GL_GEOMETRY_SHADER;
    case hlsl::Stage::fragment:
      return GL_FRAGMENT_SHADER;
    case hlsl::Stage::compute:
      break;
  }
  return GL_COMPUTE_SHADER;
}

std::string nth_line(const std::string& text, int number) {
  std::istringstream lines(text);
  std::string line;
  for (int i = 0; i < number && std::getline(lines, line);) ++i;
  return line;
}

// Mesa's form is "0:12(5): error: ...": string, line, column. Lines of another form keep their text, without
// a location.
hlsl::Diagnostic parse_line(const std::string& line, const std::string& text) {
  hlsl::Diagnostic diagnostic;
  int string_number = 0;
  int length = 0;
  char severity[16] = {};
  const int fields = std::sscanf(line.c_str(), "%d:%d(%d): %15[a-z]: %n", &string_number, &diagnostic.line,
                                 &diagnostic.column, severity, &length);
  if (fields < 4 || length == 0) {
    diagnostic.line = diagnostic.column = 0;
    diagnostic.message = line;
    diagnostic.severity =
        line.find("warning") == std::string::npos ? hlsl::Severity::error : hlsl::Severity::warning;
    return diagnostic;
  }
  diagnostic.severity = std::string(severity) == "error" ? hlsl::Severity::error : hlsl::Severity::warning;
  diagnostic.message = line.substr(static_cast<std::size_t>(length));
  diagnostic.source_line = nth_line(text, diagnostic.line);
  return diagnostic;
}

std::vector<hlsl::Diagnostic> parse_gl_log(const std::string& log, const std::string& text, bool failed) {
  std::vector<hlsl::Diagnostic> diagnostics;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) diagnostics.push_back(parse_line(line, text));
  if (failed && !hlsl::has_errors(diagnostics))
    diagnostics.push_back({{}, 0, 0, hlsl::Severity::error, "the GL driver refuses it without a reason", {}});
  if (!failed)  // a shader that the driver accepts has no error, whatever its log contains
    for (hlsl::Diagnostic& diagnostic : diagnostics) diagnostic.severity = hlsl::Severity::warning;
  return diagnostics;
}

void append(std::vector<hlsl::Diagnostic>& to, std::vector<hlsl::Diagnostic> more) {
  to.insert(to.end(), more.begin(), more.end());
}

void compile_stage(const GlFunctions& gl, GLuint program, const GlStage& stage,
                   std::vector<hlsl::Diagnostic>& out) {
  const GLuint shader = gl.create_shader(stage_enum(stage.stage));
  const char* text = stage.text.c_str();
  gl.shader_source(shader, 1, &text, nullptr);
  gl.compile_shader(shader);
  GLint compiled = GL_FALSE;
  GLint length = 0;
  gl.get_shader(shader, GL_COMPILE_STATUS, &compiled);
  gl.get_shader(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length) + 1, '\0');
  gl.shader_log(shader, length + 1, &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  append(out, parse_gl_log(log, stage.text, compiled != GL_TRUE));
  gl.attach_shader(program, shader);
  gl.delete_shader(shader);  // referenced by the program until that is deleted
}

void link_program(const GlFunctions& gl, GLuint program, std::vector<hlsl::Diagnostic>& out) {
  gl.link_program(program);
  GLint linked = GL_FALSE;
  GLint length = 0;
  gl.get_program(program, GL_LINK_STATUS, &linked);
  gl.get_program(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length) + 1, '\0');
  gl.program_log(program, length + 1, &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  append(out, parse_gl_log(log, {}, linked != GL_TRUE));
}

// Returns this thread's context of a dialect and makes it current: Mesa has one current context per thread.
Context& thread_context(Target target) {
  thread_local std::map<Target, Context> contexts;
  Context& context = contexts.try_emplace(target, target).first->second;
  context.make_current();
  return context;
}

}  // namespace

std::vector<hlsl::Diagnostic> gl_check(const std::vector<GlStage>& stages, Target target) {
  const GlFunctions& gl = thread_context(target).gl;
  const GLuint program = gl.create_program();
  if (stages.size() == 1) gl.program_parameter(program, GL_PROGRAM_SEPARABLE, GL_TRUE);
  std::vector<hlsl::Diagnostic> diagnostics;
  for (const GlStage& stage : stages) compile_stage(gl, program, stage, diagnostics);
  if (!hlsl::has_errors(diagnostics)) link_program(gl, program, diagnostics);
  gl.delete_program(program);
  for (hlsl::Diagnostic& diagnostic : diagnostics) diagnostic.file = target_name(target);
  return diagnostics;
}

std::string gl_driver(Target target) {
  return reinterpret_cast<const char*>(thread_context(target).gl.get_string(GL_VERSION));
}

}  // namespace penumbra::shaders
