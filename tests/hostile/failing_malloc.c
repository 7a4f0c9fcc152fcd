/* Preloaded (LD_PRELOAD), makes one allocation fail: the n-th of at least so many bytes after fail_after(n, bytes). */
#include <errno.h>
#include <stddef.h>

void *__libc_malloc(size_t);
void *__libc_calloc(size_t, size_t);
void *__libc_realloc(void *, size_t);
void *__libc_memalign(size_t, size_t);

static long left = 0;
static size_t least = 0;

void fail_after(long n, size_t bytes) {
  least = bytes;
  __atomic_store_n(&left, n, __ATOMIC_RELAXED);
}

static int fails(size_t size) {
  if (__atomic_load_n(&left, __ATOMIC_RELAXED) <= 0 || size < least) return 0;
  if (__atomic_sub_fetch(&left, 1, __ATOMIC_RELAXED) != 0) return 0;
  errno = ENOMEM;
  return 1;
}

void *malloc(size_t size) { return fails(size) ? NULL : __libc_malloc(size); }
void *calloc(size_t count, size_t size) { return fails(count * size) ? NULL : __libc_calloc(count, size); }
void *realloc(void *old, size_t size) { return fails(size) ? NULL : __libc_realloc(old, size); }
void *memalign(size_t alignment, size_t size) { return fails(size) ? NULL : __libc_memalign(alignment, size); }
void *aligned_alloc(size_t alignment, size_t size) { return memalign(alignment, size); }

int posix_memalign(void **out, size_t alignment, size_t size) {
  void *const found = memalign(alignment, size);
  if (found == NULL) return ENOMEM;
  *out = found;
  return 0;
}
