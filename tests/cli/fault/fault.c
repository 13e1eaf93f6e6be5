// A library that LD_PRELOAD places before the C library. It counts the operations that change files below a directory
// and makes them fail.
//
//   ISOLAW_FAULT_DIR   the directory; operations elsewhere are neither counted nor changed
//   ISOLAW_FAULT_MODE  count  nothing goes wrong
//                      once   operation number ISOLAW_FAULT_AT fails with an input/output error, all others succeed
//                      full   from that operation on there is no space left
//                      readonly  from that operation on the file system can only be read
//                      kill   the process is killed before that operation
//                      torn   the process is killed when half of that write is done
//   ISOLAW_FAULT_COUNT a file that receives the number of operations at the end of the process
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

static _Atomic long operations = 0;

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

static const char* setting(const char* name) {
  const char* value = getenv(name);
  return value ? value : "";
}

static int watched_path(const char* path) {
  const char* directory = setting("ISOLAW_FAULT_DIR");
  char absolute[8192];
  if (!path || !*directory) return 0;
  if (path[0] == '/') {
    snprintf(absolute, sizeof absolute, "%s", path);
  } else {
    char here[4096];
    if (!getcwd(here, sizeof here)) return 0;
    snprintf(absolute, sizeof absolute, "%s/%s", here, path);
  }
  return strncmp(absolute, directory, strlen(directory)) == 0;
}

static int watched_file(int file) {
  char link[64], path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  ssize_t const length = readlink(link, path, sizeof path - 1);
  if (length <= 0) return 0;
  path[length] = 0;
  return watched_path(path);
}

enum what { succeed, fail, tear };

// Counts an operation and decides whether it fails, in which case errno is set. `can_tear` is 1 for a write, which may
// also stop half-way.
static enum what next_operation(int can_tear) {
  long const number = ++operations, at = atol(setting("ISOLAW_FAULT_AT"));
  const char* mode = setting("ISOLAW_FAULT_MODE");
  if (strcmp(mode, "once") == 0 && number == at) return errno = EIO, fail;
  if (strcmp(mode, "full") == 0 && number >= at) return errno = ENOSPC, fail;
  if (strcmp(mode, "readonly") == 0 && number >= at) return errno = EROFS, fail;
  if (strcmp(mode, "kill") == 0 && number == at) raise(SIGKILL);
  if (strcmp(mode, "torn") == 0 && number == at) {
    if (can_tear) return tear;
    raise(SIGKILL);
  }
  return succeed;
}

__attribute__((destructor)) static void report_count(void) {
  const char* name = setting("ISOLAW_FAULT_COUNT");
  if (!*name) return;
  FILE* file = fopen(name, "w");
  if (!file) return;
  fprintf(file, "%ld\n", (long)operations);
  fclose(file);
}

// Counts an operation that works even on a full disk, such as removing or truncating a file. Returns 1 if it must fail.
static int frees_space_fails(void) {
  return next_operation(0) == fail && errno != ENOSPC;
}

ssize_t write(int file, const void* bytes, size_t size) {
  if (watched_file(file)) {
    enum what const what = next_operation(1);
    if (what == fail) return -1;
    if (what == tear) {
      (void)!NEXT(write)(file, bytes, size / 2);
      raise(SIGKILL);
    }
  }
  return NEXT(write)(file, bytes, size);
}

static ssize_t write_at(ssize_t (*next)(int, const void*, size_t, off_t), int file, const void* bytes, size_t size,
                        off_t offset) {
  if (watched_file(file)) {
    enum what const what = next_operation(1);
    if (what == fail) return -1;
    if (what == tear) {
      (void)!next(file, bytes, size / 2, offset);
      raise(SIGKILL);
    }
  }
  return next(file, bytes, size, offset);
}
ssize_t pwrite(int file, const void* bytes, size_t size, off_t offset) {
  return write_at(NEXT(pwrite), file, bytes, size, offset);
}
ssize_t pwrite64(int file, const void* bytes, size_t size, off_t offset) {
  return write_at(NEXT(pwrite64), file, bytes, size, offset);
}

ssize_t writev(int file, const struct iovec* parts, int count) {
  if (watched_file(file) && next_operation(0) == fail) return -1;
  return NEXT(writev)(file, parts, count);
}

static int truncate_to(int (*next)(int, off_t), int file, off_t size) {
  struct stat now;
  int const grows = fstat(file, &now) == 0 && size > now.st_size;
  if (watched_file(file) && (grows ? next_operation(0) == fail : frees_space_fails())) return -1;
  return next(file, size);
}
int ftruncate(int file, off_t size) { return truncate_to(NEXT(ftruncate), file, size); }
int ftruncate64(int file, off_t size) { return truncate_to(NEXT(ftruncate64), file, size); }

int fsync(int file) {
  if (watched_file(file) && next_operation(0) == fail) return -1;
  return NEXT(fsync)(file);
}
int fdatasync(int file) {
  if (watched_file(file) && next_operation(0) == fail) return -1;
  return NEXT(fdatasync)(file);
}

static int opening_fails(const char* path, int flags) {
  int const changes = (flags & O_ACCMODE) != O_RDONLY || (flags & (O_CREAT | O_TRUNC)) != 0;
  if (!changes || !watched_path(path)) return 0;
  int const makes = (flags & O_CREAT) != 0 && access(path, F_OK) != 0;
  // A full disk prevents a file from being created, but an existing file can still be opened.
  return makes ? next_operation(0) == fail : frees_space_fails();
}
static int mode_of(int flags, va_list arguments) { return (flags & O_CREAT) ? va_arg(arguments, int) : 0; }

#define OPENS(name)                                                              \
  int name(const char* path, int flags, ...) {                                   \
    va_list arguments;                                                           \
    va_start(arguments, flags);                                                  \
    int const mode = mode_of(flags, arguments);                                  \
    va_end(arguments);                                                           \
    if (opening_fails(path, flags)) return -1;                                   \
    return ((int (*)(const char*, int, ...))dlsym(RTLD_NEXT, #name))(path, flags, mode); \
  }
OPENS(open)
OPENS(open64)

int rename(const char* from, const char* to) {
  if (watched_path(to) && frees_space_fails()) return -1;
  return NEXT(rename)(from, to);
}
int unlink(const char* path) {
  if (watched_path(path) && access(path, F_OK) == 0 && frees_space_fails()) return -1;
  return NEXT(unlink)(path);
}
int remove(const char* path) {
  if (watched_path(path) && access(path, F_OK) == 0 && frees_space_fails()) return -1;
  return NEXT(remove)(path);
}
int mkdir(const char* path, mode_t mode) {
  if (watched_path(path) && access(path, F_OK) != 0 && next_operation(0) == fail) return -1;
  return NEXT(mkdir)(path, mode);
}
