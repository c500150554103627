// A Windows program around FXC, the compiler in D3DCompiler_47.dll: it answers requests on its standard input
// until that is closed. Outside Windows it runs under Wine, as a confined child of the program (fxc/judge.h).
//
//   fxc_worker DLL SECONDS MEGABYTES
//
// It first writes one byte when the compiler is loaded, or ends without one. Numbers are 32-bit and
// little-endian.
//   request   flags, the lengths of entry point, profile and source text, then the three texts
//   answer    kCompiled, kRefused, kTooLong or kTooLarge, the lengths of bytecode and messages, then both
// After kTooLong (processor time) and kTooLarge (memory) it ends. The text has no includes and no macros.
#define COBJMACROS
#include <windows.h>

#include <d3dcompiler.h>
#include <psapi.h>
#include <stdio.h>
#include <stdlib.h>

#include "unity_types.h"

enum { kCompiled, kRefused, kTooLong, kTooLarge };

typedef HRESULT(WINAPI* Compile)(LPCVOID, SIZE_T, LPCSTR, const D3D_SHADER_MACRO*, ID3DInclude*, LPCSTR,
                                 LPCSTR, UINT, UINT, ID3DBlob**, ID3DBlob**);

static HANDLE input;
static HANDLE output;
static CRITICAL_SECTION
    answering;  // held while an answer is written, by the main thread or, at the end, by the watch
static volatile LONG compiling;  // true while a request is being compiled
static volatile ULONGLONG used;  // processor time at its beginning, in units of 100 ns
static ULONGLONG most_time;      // the same unit
static SIZE_T most_memory;       // bytes

static int read_all(void* bytes, DWORD count) {
  char* at = bytes;
  while (count > 0) {
    DWORD got = 0;
    if (!ReadFile(input, at, count, &got, NULL) || got == 0) return 0;
    at += got;
    count -= got;
  }
  return 1;
}

static void write_all(const void* bytes, DWORD count) {
  const char* at = bytes;
  while (count > 0) {
    DWORD written = 0;
    if (!WriteFile(output, at, count, &written, NULL)) ExitProcess(1);
    at += written;
    count -= written;
  }
}

static void answer(DWORD status, const void* bytecode, DWORD bytecode_size, const void* messages,
                   DWORD messages_size) {
  const DWORD head[3] = {status, bytecode_size, messages_size};
  write_all(head, sizeof head);
  write_all(bytecode, bytecode_size);
  write_all(messages, messages_size);
}

static ULONGLONG processor_time(void) {
  FILETIME created, ended;
  ULARGE_INTEGER kernel, user;
  FILETIME of_kernel, of_user;
  if (!GetProcessTimes(GetCurrentProcess(), &created, &ended, &of_kernel, &of_user)) return 0;
  kernel.LowPart = of_kernel.dwLowDateTime;
  kernel.HighPart = of_kernel.dwHighDateTime;
  user.LowPart = of_user.dwLowDateTime;
  user.HighPart = of_user.dwHighDateTime;
  return kernel.QuadPart + user.QuadPart;
}

static SIZE_T memory(void) {
  PROCESS_MEMORY_COUNTERS counters;
  return K32GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters) ? counters.WorkingSetSize
                                                                                  : 0;
}

// Ends the process with an answer when a request exceeds a limit.
static DWORD WINAPI watch(LPVOID unused) {
  (void)unused;
  for (;;) {
    Sleep(50);
    if (!compiling) continue;
    DWORD status = kCompiled;
    // `used` is read first, because the next request may begin in between.
    const ULONGLONG begun = used;
    const ULONGLONG now = processor_time();
    if (now > begun && now - begun > most_time) status = kTooLong;
    if (memory() > most_memory) status = kTooLarge;
    if (status == kCompiled) continue;
    EnterCriticalSection(&answering);
    if (compiling && used == begun) {
      answer(status, NULL, 0, NULL, 0);
      ExitProcess(2);
    }
    LeaveCriticalSection(&answering);
  }
}

static void serve(Compile compile, const DWORD head[4], char* texts) {
  char* entry = texts;
  char* profile = entry + head[1] + 1;
  const char* source = profile + head[2] + 1;
  ID3DBlob* bytecode = NULL;
  ID3DBlob* messages = NULL;
  used = processor_time();
  InterlockedExchange(&compiling, 1);
  const HRESULT result =
      compile(source, head[3], NULL, types_of_unity, NULL, entry, profile, head[0], 0, &bytecode, &messages);
  EnterCriticalSection(&answering);
  InterlockedExchange(&compiling, 0);
  if (result == E_OUTOFMEMORY) {  // FXC got less memory than it may have, or has used all of it
    answer(kTooLarge, NULL, 0, NULL, 0);
    ExitProcess(2);
  }
  const int compiled = SUCCEEDED(result) && bytecode != NULL;
  answer(compiled ? kCompiled : kRefused, compiled ? ID3D10Blob_GetBufferPointer(bytecode) : NULL,
         compiled ? (DWORD)ID3D10Blob_GetBufferSize(bytecode) : 0,
         messages ? ID3D10Blob_GetBufferPointer(messages) : NULL,
         messages ? (DWORD)ID3D10Blob_GetBufferSize(messages) : 0);
  LeaveCriticalSection(&answering);
  if (bytecode) ID3D10Blob_Release(bytecode);
  if (messages) ID3D10Blob_Release(messages);
}

int main(int count, char** arguments) {
  if (count != 4) return 1;
  input = GetStdHandle(STD_INPUT_HANDLE);
  output = GetStdHandle(STD_OUTPUT_HANDLE);
  most_time = strtoull(arguments[2], NULL, 10) * 10000000ULL;
  most_memory = (SIZE_T)(strtoull(arguments[3], NULL, 10) << 20);
  SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX);
  const HMODULE library = LoadLibraryA(arguments[1]);
  const Compile compile = library ? (Compile)(void*)GetProcAddress(library, "D3DCompile") : NULL;
  InitializeCriticalSection(&answering);
  if (!compile || !CreateThread(NULL, 0, watch, NULL, 0, NULL)) return 1;
  write_all("r", 1);
  for (;;) {
    DWORD head[4];
    if (!read_all(head, sizeof head)) return 0;
    // The texts, each with a zero behind it.
    char* texts = calloc(1, (size_t)head[1] + head[2] + head[3] + 3);
    if (!texts) return 1;
    if (!read_all(texts, head[1]) || !read_all(texts + head[1] + 1, head[2]) ||
        !read_all(texts + head[1] + head[2] + 2, head[3]))
      return 0;
    serve(compile, head, texts);
    free(texts);
  }
}
